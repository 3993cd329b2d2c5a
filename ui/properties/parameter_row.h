// The row of one parameter of an operation, made of what its kind says of it: a box, buttons, a
// list, or a slider with a field.
#pragma once

#include "core/model/evaluation.h"
#include "core/operations/operation_kind.h"
#include "ui/properties/property_rows.h"

#include <functional>
#include <optional>

class QCheckBox;
class QToolButton;

namespace fff::ui {

class SegmentedBox;
class SliderField;

class ParameterRow : public PropertyRow
{
public:
    struct Reactions
    {
        std::function<void(const ParameterValue &)> dragged; // on the way
        /// Done: one step of the history. Nothing: it follows from the inputs again.
        std::function<void(std::optional<ParameterValue>)> settled;
        std::function<void()> cancelled;
    };

    /// The spec outlives the row.
    ParameterRow(const ParameterSpec &spec, Reactions reactions, QWidget *parent);

    const ParameterSpec &spec() const { return m_spec; }
    /// As the operation has it. result: what it came to; null: it is off.
    void show(const Operation &operation, const OperationResult *result);
    void refresh() override {}
    /// What waits to be announced is, now.
    void settle();
    /// Of a number.
    void setFollowed(Followed followed);

private:
    void makeSwitch();
    void makeChoice();
    void makeNumber();
    NumberEdit *numberEdit();

    const ParameterSpec &m_spec;
    const Reactions m_reactions;
    QCheckBox *m_switch = nullptr;
    SegmentedBox *m_segments = nullptr;
    ChoiceBox *m_choice = nullptr;
    SliderField *m_number = nullptr;
    NumberEdit *m_field = nullptr;
    QToolButton *m_free = nullptr; // sets it free again
};

} // namespace fff::ui
