// What scripts say of sections and operations, as parameters of commands.
#pragma once

#include "core/interaction/commands.h"
#include "core/model/model.h"
#include "core/operations/operation_kind.h"

namespace fff {

/// Null when nothing is said of it.
const std::string *textOf(const CommandParameters &parameters, const std::string &key);

/// By its name, in what is there now; none: no section has it.
std::optional<SectionRef> sectionNamed(const Model &model, const std::string &name);

/// By the parameter "operation", else the one that is meant without a name (may be invalid).
/// Errors  BadValue, place = "operation".
Result<OperationPointer> operationNamed(const Model &model, const CommandParameters &parameters,
                                        OperationId otherwise);

/// What the parameters say of an operation. Errors  BadValue, place = the key.
Result<Operation> withParameters(const Model &model, const OperationKind &kind, Operation operation,
                                 const CommandParameters &parameters);

/// A section that an operation made, by its name, or that of the operation with the key below it
/// ("Ribs/3"), as one that is left out has no name.
/// Errors  BadValue, place = "section".
Result<SectionRef> instanceNamed(const Model &model, const std::string &name);

} // namespace fff
