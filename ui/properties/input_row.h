// What an operation works on, of one role: a field that names the section, or a list of them, and
// the picker beside it, which asks for another one in the view.
#pragma once

#include "core/model/model.h"
#include "core/operations/operation_kind.h"
#include "ui/properties/property_rows.h"

#include <functional>
#include <vector>

class QAbstractButton;
class QListWidget;
class QToolButton;

namespace fff::ui {

class InputRow : public PropertyRow
{
public:
    struct Reactions
    {
        std::function<void()> pick;                                 // another one, or one more
        std::function<void(std::vector<OperationInput>)> reordered; // or with some taken out
        std::function<void(const SectionRef &)> hovered;            // an empty one: none
    };

    /// The spec outlives the row.
    InputRow(const InputSpec &spec, Reactions reactions, QWidget *parent);

    /// model: that is shown. picks: the view asks for it now.
    void show(const Operation &operation, const Model &model, bool picks);
    void refresh() override {}

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void makeField();
    void makeList();
    void showList(const Model &model);
    void takeOut();
    void moveCurrent(int by);
    void takeOrder();
    void outline(const SectionRef &section);
    /// What the section is called now, else what it was, and whether it is there.
    static std::pair<QString, bool> nameOf(const OperationInput &input, const Model &model);

    const InputSpec &m_spec;
    const Reactions m_reactions;
    QAbstractButton *m_field = nullptr;
    QListWidget *m_list = nullptr;
    QToolButton *m_pick = nullptr, *m_takeOut = nullptr; // of the list
    std::vector<OperationInput> m_inputs;
    bool m_isFilling = false;
    bool m_isOutlining = false; // what is outlined is ours
};

} // namespace fff::ui
