// The properties of the operation that is selected: what it works on, its numbers, what of its
// sections is otherwise, and what can be done with it as a whole. Numbers are shown live while they
// are dragged; each drag is one step of the history.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/model.h"

#include <map>
#include <vector>

class QPushButton;

namespace fff {
struct OperationKind;
struct ParameterSpec;
} // namespace fff

namespace fff::ui {

class ExceptionRows;
class InputRow;
class ParameterRow;
class ProblemBox;
class PropertyGroup;
class Workbench;

class OperationPage : public QWidget
{
    Q_OBJECT
public:
    OperationPage(Workbench &bench, QWidget *parent);

    /// Another operation may be selected: what waits to be announced of the one before is, first.
    void follow();
    void refresh();
    /// The field of a parameter has the focus then.
    void focusParameter(const QString &key);

private:
    /// The rows of one kind, made when one of it is selected for the first time.
    struct Panel
    {
        QWidget *box = nullptr;
        QWidget *first = nullptr; // the group of the inputs
        std::vector<InputRow *> inputs;
        std::vector<ParameterRow *> parameters;
    };
    Panel &panelOf(const OperationKind &kind);
    InputRow *inputRow(const OperationKind &kind, std::size_t index, QWidget *parent);
    ParameterRow *parameterRow(const ParameterSpec &spec, QWidget *parent);
    void addFooter();
    void tellNotices(const Operation &operation, const OperationResult *result);
    void followLink(const QString &target);

    /// As committed. Null: there is none.
    const Operation *operation() const;
    void preview(const std::string &key, const ParameterValue &value);
    void commit(const std::string &key, std::optional<ParameterValue> value);
    void commitInputs(const std::string &role, std::vector<OperationInput> inputs);

    Workbench &m_bench;
    OperationId m_id;
    ProblemBox *m_problem = nullptr;
    QWidget *m_panels = nullptr;
    std::map<std::string, Panel> m_byKind;
    Panel *m_shown = nullptr;
    ExceptionRows *m_exceptions = nullptr;
    QPushButton *m_bake = nullptr;
};

} // namespace fff::ui
