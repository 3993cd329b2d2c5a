#include "ui/window/context_menu.h"

#include "core/interaction/transform_tool.h"
#include "core/model/origin.h"
#include "ui/actions/action_set.h"
#include "ui/base/theme.h"
#include "ui/bench/workbench.h"

#include <QMenu>
#include <QWidget>

#include <algorithm>
#include <string_view>

namespace fff::ui {

namespace {

/// What a tool asks for is answered first; the handles ask for nothing.
bool isBusy(const Interaction &interaction)
{
    const Tool *tool = interaction.tool();
    return interaction.hasGesture() || (tool && tool->command() != TransformTool::kCommand);
}

} // namespace

ContextMenu::ContextMenu(Workbench &bench, ActionSet &actions, QWidget *view)
    : QObject(view), m_bench(bench), m_actions(actions), m_view(view)
{
}

const char *ContextMenu::ofSelection() const
{
    const Interaction &interaction = m_bench.interaction();
    if (!interaction.points().isEmpty())
        return "context.point";
    if (interaction.selectedJoint())
        return "context.joint";
    if (interaction.selectedOperation().isValid())
        return "context.operation";
    const std::vector<SectionRef> sections = interaction.sectionsInFocus();
    if (sections.empty())
        return "context.empty";
    const Model &model = m_bench.session().committed();
    return originOf(model, sections.front()) ? "context.section" : "context.made";
}

const char *ContextMenu::chooseHovered()
{
    const Interaction &interaction = m_bench.interaction();
    if (const std::optional<PointTarget> target = interaction.hoveredPoint()) {
        if (target->kind == PointTarget::Kind::Line)
            return "context.contour";
        const std::vector<PointAddress> &points = interaction.points().points();
        if (std::find(points.begin(), points.end(), target->point) == points.end())
            m_bench.run(QStringLiteral("point.select"),
                        {{"boundary", std::to_string(target->point.boundary)},
                         {"index", std::to_string(target->point.index)}});
        return ofSelection();
    }
    const auto *joints = interaction.overlay().find<sign::Joints>();
    if (joints && joints->hovered >= 0) {
        m_bench.selectJoint(joints->marks[static_cast<std::size_t>(joints->hovered)].joint);
        return ofSelection();
    }
    const int index = interaction.hovered().section;
    if (index < 0)
        return "context.empty";
    const SectionRef hovered = m_bench.session().committed().ref(static_cast<std::size_t>(index));
    const std::vector<SectionRef> selected = interaction.sectionsInFocus();
    if (std::find(selected.begin(), selected.end(), hovered) == selected.end())
        m_bench.select({hovered});
    return interaction.points().isEmpty() ? ofSelection() : "context.section";
}

void ContextMenu::openAt(const QPoint &inView)
{
    if (!isBusy(m_bench.interaction()))
        open(chooseHovered(), m_view->mapToGlobal(inView));
}

void ContextMenu::openForSelection()
{
    const Interaction &interaction = m_bench.interaction();
    if (isBusy(interaction))
        return;
    Box3 box;
    const Model &model = m_bench.session().committed();
    for (const SectionRef &ref : interaction.sectionsInFocus())
        if (const Section *section = model.find(ref))
            box.extend(worldBounds(*section->shape, section->frame));
    QPoint place = m_view->rect().center();
    if (!box.isEmpty()) {
        const Vec2 at =
            interaction.camera().toScreen(box.center(), Vec2(m_view->width(), m_view->height()));
        const QPoint middle(static_cast<int>(at.x()), static_cast<int>(at.y()));
        place = m_view->rect().contains(middle) ? middle : place;
    }
    open(ofSelection(), m_view->mapToGlobal(place));
}

void ContextMenu::openInList(const QPoint &onScreen, QAction *rename)
{
    if (isBusy(m_bench.interaction()))
        return;
    const std::string_view key = ofSelection();
    const bool isSection = key == "context.section" || key == "context.point";
    open(isSection ? "context.outline" : key.data(), onScreen, rename);
}

void ContextMenu::open(const char *key, const QPoint &onScreen, QAction *rename)
{
    auto *menu = new QMenu(m_view);
    menu->setObjectName(QStringLiteral("contextMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    m_actions.fill(menu, key, [rename](const QString &, QMenu *at) {
        if (rename)
            at->addAction(rename);
    });
    dress(menu);
    for (QMenu *deeper : menu->findChildren<QMenu *>())
        dress(deeper);
    menu->popup(onScreen);
}

} // namespace fff::ui
