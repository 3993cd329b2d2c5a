// What kinds of operations there are, what each asks for, and how it makes sections of it. A kind
// is one file in this folder and its line in operation_kinds.cpp: the panel, the prompts, the file,
// the command line's listing and scripts all read what is said here.
#pragma once

#include "core/operations/operation_context.h"

#include <span>
#include <string_view>
#include <vector>

namespace fff {

/// One of the choices that a parameter has.
struct ChoiceSpec
{
    const char *key;
    const char *label; // English, marked for translation in the context "Operation", as all here
};

struct ParameterSpec
{
    enum class Unit {
        Switch, // a bool
        Choice, // the key of one of `choices`
        Count,  // a whole number
        Length, // mm
        Angle,  // radians
        Share,  // of 1, said as percent
        Number  // without a unit, whole (a seed)
    };
    const char *key;
    const char *label;
    Unit unit = Unit::Switch;
    double standard = 0.0; // of a switch 0 or 1, of a choice its index
    /// Of a number: what is taken, in what steps the field goes, and what the slider spans.
    double least = 0.0, most = 0.0, step = 1.0;
    double sliderLeast = 0.0, sliderMost = 0.0;
    std::vector<ChoiceSpec> choices = {};
    /// It counts only while the parameter of this key has one of these values ("spacing", or "true"
    /// and "false"); null: always.
    const char *countsIf = nullptr;
    std::vector<const char *> countsFor = {};
    /// It may be missing: then it follows from the inputs, and the result says what it is.
    bool isFree = false;
    /// Here begins a group of parameters of this name; those before the first one stand with the
    /// inputs.
    const char *heading = nullptr;
    const char *tip = nullptr; // what the label leaves open
};

struct InputSpec
{
    const char *role;
    const char *label;
    const char *prompt; // "Click the section to repeat."
    int least = 1, most = 1;
    /// As those of ParameterSpec.
    const char *countsIf = nullptr;
    std::vector<const char *> countsFor = {};
};

struct OperationKind
{
    const char *key;
    int version = 1;
    const char *name;
    const char *summary; // a sentence
    /// What one is called by itself after its first input: "%1 row". Null: as the kind.
    const char *(*calls)(const Operation &operation) = nullptr;
    std::vector<InputSpec> inputs;
    std::vector<ParameterSpec> parameters;
    /// Parameters that have a handle in the view, which goes along the result's track.
    std::vector<const char *> handles = {};
    void (*make)(OperationContext &context) = nullptr;
    /// Of kinds that can be about the whole model: whether this one is, and the same about these
    /// sections alone. False: that would be too many.
    bool (*isOfAll)(const Operation &operation) = nullptr;
    bool (*narrow)(Operation &operation, std::vector<OperationInput> sections) = nullptr;
    /// It makes sections of a template (Operation::subject) and a stock.
    bool isOfTemplate = false;

    const ParameterSpec *parameter(std::string_view key) const;
    const InputSpec *input(std::string_view role) const;
};

/// In the order of the tool bar.
std::span<const OperationKind *const> operationKinds();
/// Null for one that this version does not know.
const OperationKind *operationKind(std::string_view key);

/// A new one of the kind, without inputs, with the standard values of all parameters that have one.
Operation newOperation(const OperationKind &kind);

/// How many sections it has in this role, and the first role that has fewer than it needs, or null.
int countOf(const Operation &operation, const InputSpec &input);
const InputSpec *missingInput(const OperationKind &kind, const Operation &operation);
/// The first of its inputs in the order of the kind's roles: what it is mainly about. Null: none.
const OperationInput *firstInput(const Operation &operation);

/// Whether it counts with the other values as they are.
bool counts(const ParameterSpec &spec, const Operation &operation);
bool counts(const InputSpec &spec, const Operation &operation);
/// The value, or the standard one where it is missing or is none of this parameter's; numbers are
/// brought into their range. Missing where it is free: nothing.
std::optional<ParameterValue> valueOf(const ParameterSpec &spec, const Operation &operation);
/// Numbers as people say them: angles in degrees, shares in percent, all else as it is; and back.
double spokenValue(ParameterSpec::Unit unit, double value);
double valueSpoken(ParameterSpec::Unit unit, double spoken);
/// What is taken, as people say it: "0 … 100", "count, spacing".
std::string rangeText(const ParameterSpec &spec);
/// What a text says as a value of this parameter: "true", "12.7", "spacing"; numbers as people say
/// them. Errors  BadValue, place = the parameter's key, args = the text and rangeText().
Result<ParameterValue> parsedValue(const ParameterSpec &spec, const std::string &text);
/// Whether the parameter can have it.
bool isAllowed(const ParameterSpec &spec, const ParameterValue &value);

} // namespace fff
