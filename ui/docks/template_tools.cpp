#include "ui/docks/template_tools.h"

#include "core/interaction/size_line_tool.h"
#include "core/interaction/template_tool.h"
#include "ui/base/icon.h"
#include "ui/bench/workbench.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace fff::ui {

namespace {

constexpr int kToolGap = 6, kAboveTools = 2; // px

} // namespace

TemplateTools::TemplateTools(Workbench &bench, std::function<const Template *()> chosen,
                             QWidget *parent)
    : QWidget(parent), m_bench(bench), m_chosen(std::move(chosen))
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, kAboveTools, 0, kToolGap);
    row->setSpacing(kToolGap);
    addTool(tr("Move and turn"), "templateHandles",
            tr("Move, turn and scale it in the view, with handles or numbers"),
            TemplateTool::kCommand);
    addTool(tr("Size by a line"), "templateSizeByLine",
            tr("Draw a line over something in it whose length you know"), SizeLineTool::kCommand);
    connect(&bench, &Workbench::viewStateChanged, this, &TemplateTools::refresh);
    // Whoever selects something else is done with it.
    connect(&bench, &Workbench::selectionChanged, this, [this] {
        if (held(TemplateTool::kCommand).isValid() && !m_bench.interaction().selection().empty())
            m_bench.layDownTool();
    });
}

QPushButton *TemplateTools::addTool(const QString &text, const char *name, const QString &tip,
                                    std::string_view command)
{
    auto *button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setAutoDefault(false);
    button->setCheckable(true);
    connect(button, &QPushButton::clicked, this, [this, command] {
        run(command);
        refresh(); // what is checked says what is so, not what was clicked
        if (held(command).isValid())
            Q_EMIT viewWanted();
    });
    layout()->addWidget(button);
    m_buttons.push_back({command, button});
    return button;
}

TemplateId TemplateTools::held(std::string_view command) const
{
    const Tool *tool = m_bench.interaction().tool();
    if (!tool || tool->command() != command)
        return {};
    if (const auto *handles = dynamic_cast<const TemplateTool *>(tool))
        return handles->of();
    const auto *line = dynamic_cast<const SizeLineTool *>(tool);
    return line ? line->of() : TemplateId();
}

void TemplateTools::run(std::string_view command)
{
    if (const Template *one = m_chosen())
        m_bench.run(QString::fromLatin1(command.data(), static_cast<qsizetype>(command.size())),
                    {{"template", one->name}});
}

void TemplateTools::hold()
{
    const Template *one = m_chosen();
    if (one && !one->isLocked && !one->isHidden && one->isRead() &&
        held(TemplateTool::kCommand) != one->id)
        run(TemplateTool::kCommand);
}

void TemplateTools::follow()
{
    const Template *one = m_chosen();
    for (const Button &each : m_buttons) {
        const TemplateId now = held(each.command);
        if (!now.isValid() || (one && now == one->id))
            continue;
        m_bench.layDownTool();
        if (one && !one->isLocked && !one->isHidden)
            run(each.command);
    }
}

bool TemplateTools::escape()
{
    for (const Button &each : m_buttons)
        if (held(each.command).isValid())
            return m_bench.escape();
    return false;
}

void TemplateTools::refresh()
{
    const Template *one = m_chosen();
    const bool isHeld = one && !one->isLocked && !one->isHidden && one->isRead();
    for (const Button &each : m_buttons) {
        each.button->setEnabled(isHeld);
        each.button->setChecked(one && held(each.command) == one->id);
    }
}

} // namespace fff::ui
