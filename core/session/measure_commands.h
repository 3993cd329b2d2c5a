// Commands of lengths.
//
//   measure.ruler       picks up the tool that measures
//   measure.dimension   picks up the one that says how long a line shall be
//   measure.keep        the measured line stays as a dimension
//   measure.remove      the dimension in the hand, or number `dimension` (from 0), goes
//   measure.scale       factor; or dimension and length (mm): the whole model is scaled
//   numbers.set         name, value, expression: a number that can be called by its name
//   numbers.remove      name
//   numbers.rename      name, to
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff::steps {

//: %1 is the name of a number
inline constexpr Text kSetNumber = FFF_TEXT("Step", "Set %1");

} // namespace fff::steps

namespace fff {

void registerMeasureCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
