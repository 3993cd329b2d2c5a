// Commands that move, turn and scale what is selected, and say how it is held.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// section.transform        the gizmo in the hand
/// transform.inSpace, transform.withChildren   switches of what it and the keys go by
/// section.move             x, y, z: mm; right, up, out: the same as its plane lies
/// section.turn             angle: degrees; axis: x, y, z, or normal (which it is without)
/// section.scale            factor; of one section in its plane, with x and y two factors
///                          All three: copies: so many, each one a step further, in place of it
/// section.place            x, y, z: coordinates of its middle; angle: to what it is on, degrees
/// section.free             switch
/// section.lock             switch
/// section.makeOrthogonal, section.snapNormal
/// section.putOn            on: the name of a section, or none; without it, asked for in the view
/// operation.editSource     selects what the operation, or what is selected of it, is made of
/// operation.detach         makes a drawn section of the one that is selected of it
/// operation.leaveOut       does not make that one any more
/// Each that changes the model is one step of the history. The session and the interaction outlive
/// the registry.
void registerSectionCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
