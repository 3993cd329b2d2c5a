#include "ui/docks/operation_page.h"

#include "core/interaction/tool.h"
#include "core/model/operation_edits.h"
#include "core/operations/operation_kind.h"
#include "core/operations/operation_words.h"
#include "core/session/operation_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"
#include "ui/docks/problem_box.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/exception_rows.h"
#include "ui/properties/input_row.h"
#include "ui/properties/parameter_row.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

/// More may be made by this much, when somebody allows it.
constexpr double kMoreSections = 2.0;

QVBoxLayout *plainColumn(QWidget *of)
{
    auto *column = new QVBoxLayout(of);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    return column;
}

} // namespace

OperationPage::OperationPage(Workbench &bench, QWidget *parent) : QWidget(parent), m_bench(bench)
{
    m_problem = new ProblemBox("operationProblem", this);
    connect(m_problem, &ProblemBox::linkActivated, this, &OperationPage::followLink);
    m_panels = new QWidget(this);
    plainColumn(m_panels);
    auto *exceptions = new PropertyGroup(tr("Exceptions"), this);
    m_exceptions = new ExceptionRows(exceptions);
    m_exceptions->setObjectName(QStringLiteral("exceptions"));
    exceptions->add(m_exceptions);
    connect(m_exceptions, &ExceptionRows::showWanted, this, [this](const SectionRef &instance) {
        m_bench.commit(Step{steps::kShowInstance},
                       setExceptionState(m_bench.session().committed().document, instance,
                                         Exception::State::Made));
    });
    QVBoxLayout *column = plainColumn(this);
    column->addWidget(m_problem);
    column->addWidget(m_panels);
    column->addWidget(exceptions);
    addFooter();
}

void OperationPage::addFooter()
{
    auto *footer = new QWidget(this);
    auto *row = new QHBoxLayout(footer);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    const auto add = [&](const QString &text, const char *name, const char *icon, const char *id) {
        auto *button = new QPushButton(text, footer);
        button->setObjectName(QLatin1String(name));
        button->setIcon(themedIcon(QLatin1String(icon)));
        button->setAutoDefault(false);
        button->setMinimumHeight(28);
        connect(button, &QPushButton::clicked, this,
                [this, id] { m_bench.run(QLatin1String(id)); });
        row->addWidget(button, 1);
        return button;
    };
    m_bake = add(tr("Bake"), "operationBake", "bake", "operation.bake");
    m_bake->setToolTip(
        tr("Turn what it makes into drawn sections; the operation itself is then gone"));
    add(tr("Delete"), "operationDelete", "trash", "operation.delete")
        ->setToolTip(tr("Delete it and everything it makes"));
    layout()->addWidget(footer);
}

InputRow *OperationPage::inputRow(const OperationKind &kind, std::size_t index, QWidget *parent)
{
    const InputSpec &spec = kind.inputs[index];
    const std::string role = spec.role;
    return new InputRow(spec,
                        {[this, role] {
                             m_bench.run(QStringLiteral("operation.choose"), {{"role", role}});
                         },
                         [this, role](std::vector<OperationInput> inputs) {
                             commitInputs(role, std::move(inputs));
                         },
                         [this](const SectionRef &section) {
                             m_bench.setOutlined(section == SectionRef()
                                                     ? std::vector<SectionRef>()
                                                     : std::vector<SectionRef>{section});
                         }},
                        parent);
}

ParameterRow *OperationPage::parameterRow(const ParameterSpec &spec, QWidget *parent)
{
    const std::string key = spec.key;
    auto *row = new ParameterRow(
        spec,
        {[this, key](const ParameterValue &value) { preview(key, value); },
         [this, key](std::optional<ParameterValue> value) { commit(key, std::move(value)); },
         [this] { m_bench.session().cancelPreview(); }},
        parent);
    row->setFollowed(followedAt(m_bench, [this, key] {
        return std::optional(
            DrivenPlace{.of = DrivenPlace::Of::Operation, .id = m_id.value, .field = key});
    }));
    return row;
}

OperationPage::Panel &OperationPage::panelOf(const OperationKind &kind)
{
    const auto [at, isNew] = m_byKind.try_emplace(kind.key);
    Panel &panel = at->second;
    if (!isNew)
        return panel;
    panel.box = new QWidget(m_panels);
    QVBoxLayout *column = plainColumn(panel.box);
    PropertyGroup *group = nullptr;
    const auto begin = [&](const QString &name) {
        group = new PropertyGroup(name, panel.box);
        column->addWidget(group);
    };
    begin(tr("Inputs"));
    panel.first = group;
    for (std::size_t i = 0; i < kind.inputs.size(); ++i) {
        panel.inputs.push_back(inputRow(kind, i, group));
        group->add(panel.inputs.back());
    }
    for (const ParameterSpec &spec : kind.parameters) {
        if (spec.heading)
            begin(operationText(spec.heading));
        panel.parameters.push_back(parameterRow(spec, group));
        group->add(panel.parameters.back());
    }
    m_panels->layout()->addWidget(panel.box);
    dress(panel.box); // the window is dressed by then
    return panel;
}

const Operation *OperationPage::operation() const
{
    return m_bench.session().committed().document.find(m_id);
}

void OperationPage::preview(const std::string &key, const ParameterValue &value)
{
    const Operation *known = operation();
    if (!known)
        return;
    Operation next = *known;
    next.parameters.insert_or_assign(key, value);
    if (Result<Document> document =
            setOperation(m_bench.session().committed().document, std::move(next)))
        m_bench.session().preview(*std::move(document));
}

void OperationPage::commit(const std::string &key, std::optional<ParameterValue> value)
{
    const Operation *known = operation();
    if (!known)
        return;
    Operation next = *known;
    const auto found = known->parameters.find(key);
    const Step step = steps::changed(
        *known, key, found == known->parameters.end() ? std::nullopt : std::optional(found->second),
        value);
    if (value)
        next.parameters.insert_or_assign(key, *std::move(value));
    else
        next.parameters.erase(key);
    if (next == *known)
        m_bench.session().cancelPreview();
    else
        m_bench.commit(step, setOperation(m_bench.session().committed().document, std::move(next)));
    refresh(); // buttons that were pressed show what is so
}

void OperationPage::commitInputs(const std::string &role, std::vector<OperationInput> inputs)
{
    const Operation *known = operation();
    if (!known)
        return;
    Operation next = *known;
    next.inputs.insert_or_assign(role, std::move(inputs));
    m_bench.commit(steps::changed(*known),
                   setOperation(m_bench.session().committed().document, std::move(next)));
}

void OperationPage::followLink(const QString &target)
{
    const Operation *known = operation();
    if (!known)
        return;
    if (target == QLatin1String("more")) {
        const OperationKind *kind = operationKind(known->kind);
        const ParameterSpec *most = kind ? kind->parameter("most") : nullptr;
        const std::optional<ParameterValue> now = most ? valueOf(*most, *known) : std::nullopt;
        if (now)
            commit("most",
                   ParameterValue(std::min(most->most, kMoreSections * std::get<double>(*now))));
        return;
    }
    m_bench.run(QStringLiteral("operation.choose"), {{"role", target.toStdString()}});
}

void OperationPage::tellNotices(const Operation &operation, const OperationResult *result)
{
    QStringList lines;
    bool fails = false;
    for (const OperationNotice &notice :
         result ? result->notices : std::vector<OperationNotice>()) {
        QString line = noticeText(notice, operation).toHtmlEscaped();
        fails = fails || isFailure(notice);
        const OperationKind *kind = operationKind(operation.kind);
        if (notice.kind == OperationNotice::Kind::InputMissing)
            line += QStringLiteral(" ") + linkTo(tr("Choose"), QString::fromStdString(notice.role));
        else if (notice.kind == OperationNotice::Kind::StoppedAtMost && kind &&
                 kind->parameter("most"))
            line += QStringLiteral(" ") + linkTo(tr("Allow more"), QStringLiteral("more"));
        lines += line;
    }
    if (lines.isEmpty())
        m_problem->hide();
    else
        m_problem->tell(fails ? Severity::Error : Severity::Warning,
                        lines.join(QStringLiteral("<br>")));
}

void OperationPage::follow()
{
    const OperationId selected = m_bench.interaction().selectedOperation();
    if (selected == m_id)
        return;
    if (m_shown)
        for (ParameterRow *row : m_shown->parameters)
            row->settle();
    m_id = selected;
}

void OperationPage::refresh()
{
    follow();
    const Model &model = m_bench.session().model();
    const Operation *known = model.document.find(m_id);
    const OperationKind *kind = known ? operationKind(known->kind) : nullptr;
    if (!known)
        return;
    Panel *panel = kind ? &panelOf(*kind) : nullptr;
    if (panel != m_shown) {
        if (m_shown)
            m_shown->box->hide();
        if (panel)
            panel->box->show();
        m_shown = panel;
    }
    const OperationResult *result = model.resultOf(m_id);
    tellNotices(*known, result);
    const Tool *tool = m_bench.interaction().tool();
    const Tool::Asked asked = tool ? tool->asksFor() : Tool::Asked();
    const std::string picked = asked.operation == m_id ? asked.role : std::string();
    if (panel) {
        for (std::size_t i = 0; i < panel->inputs.size(); ++i)
            panel->inputs[i]->show(*known, model, picked == kind->inputs[i].role);
        for (ParameterRow *row : panel->parameters)
            row->show(*known, result);
        // One that asks for nothing has nothing under it.
        const auto isInIt = [panel](const QWidget *row) {
            return panel->first->isAncestorOf(row) && !row->isHidden();
        };
        panel->first->setVisible(
            std::any_of(panel->inputs.begin(), panel->inputs.end(), isInIt) ||
            std::any_of(panel->parameters.begin(), panel->parameters.end(), isInIt));
    }
    if (!m_bench.session().hasPreview()) // a number that is dragged changes none of them
        m_exceptions->show(*known, model);
}

void OperationPage::focusParameter(const QString &key)
{
    for (ParameterRow *row : m_shown ? m_shown->parameters : std::vector<ParameterRow *>())
        if (key == QLatin1String(row->spec().key))
            row->setFocus(Qt::ShortcutFocusReason);
}

} // namespace fff::ui
