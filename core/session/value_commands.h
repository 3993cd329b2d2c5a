// Commands of values with names, and of numbers that are made of them. What is typed means mm,
// degrees and kg where it has no unit.
//
//   value.add      name, expression; kind ("length"), least, most, step, choices ("a|b"), note,
//                  shown
//   value.set      name; what of it is another one: those of value.add
//   value.rename   name, to: everywhere
//   value.remove   name: its users become numbers
//   value.bind     place ("stock/1/thickness", core/operations/drivable.h), expression; a plain
//                  number ends a binding
//   value.release  place: the number stays as it is
//   value.handOn   on: whoever opens the model adjusts its shown values, and no more; else the
//                  other way round than it is
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

void registerValueCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
