// Commands that add operations and change them. Names are those of sections and operations in the
// model; a list has one on a line.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// operation.KIND      one for each kind (core/operations): its parameters by their keys, numbers
///                     as people say them; its inputs by their roles; name: of the operation.
///                     Inputs that are not said are those that are selected, in their order.
///                     Without any parameter, inputs that are missing are asked for in the view
/// operation.change    operation: its name, as for those below; without it the one that is
///                     selected; parameters, inputs and name as above
/// operation.choose    operation, role: asks in the view for another input of it
/// operation.switch    operation, on
/// operation.move      operation, to: its new place in the order, 1 …
/// operation.moveUp, operation.moveDown  operation
/// operation.delete    operation
/// operation.bake      operation
/// operation.symmetric parameters of a mirror: its copies are drawn, and no operation stays
/// operation.exclude   section: the name of one that an operation made; state: hidden, detached or
///                     made; without a section that which is selected
/// Each is one step of the history. The session and the interaction outlive the registry.
void registerOperationCommands(CommandRegistry &registry, Session &session,
                               Interaction &interaction);

/// What an operation is called by itself: "Rib row", "Rib row (2)", "Mirror 1".
std::string freeOperationName(const Document &document, const Operation &operation);

} // namespace fff
