// A procedural operation as the document holds it: which kind, what it reads, its numbers, and what
// is other than it would make it. What a kind means by all that is in core/operations.
#pragma once

#include "core/base/ids.h"
#include "core/model/section.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace fff {

/// A switch, a number (mm, radians, a share of 1, a count) or the key of a choice.
using ParameterValue = std::variant<bool, double, std::string>;

/// A section that an operation reads, and what that was called when it was last there: so that one
/// that is gone can be spoken of.
struct OperationInput
{
    SectionRef section;
    std::string name = {};

    bool operator==(const OperationInput &) const = default;
};

/// What is other than the operation would make it, of one section that it makes.
struct Exception
{
    enum class State {
        Made,
        Hidden,  // it is not made
        Detached // it is not made, as a drawn section took its place
    };
    State state = State::Made;
    StockId stock = {}; // valid: it is of this one

    bool isEmpty() const { return state == State::Made && !stock.isValid(); }
    bool operator==(const Exception &) const = default;
};

/// Kinds, their inputs by role and their parameters by key: core/operations/operation_kind.h. All
/// that a file holds is kept, also roles and keys that do not count now.
struct Operation
{
    OperationId id;
    std::string kind;
    int version = 1; // of the kind that it was made with: a later one never reshapes it
    std::string name;
    bool isOn = true;
    std::map<std::string, std::vector<OperationInput>> inputs;
    /// Of kinds that make sections of a template: of which, and of what they are.
    TemplateId subject = {};
    StockId stock = {};
    std::map<std::string, ParameterValue> parameters;
    std::map<std::string, Exception> exceptions; // by the instance's key, none of them empty

    bool operator==(const Operation &) const = default;
};

using OperationPointer = std::shared_ptr<const Operation>;

} // namespace fff
