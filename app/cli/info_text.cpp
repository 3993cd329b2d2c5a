#include "app/cli/info.h"

#include "core/analysis/checks.h"
#include "core/assembly/step_groups.h"
#include "core/fabrication/summary.h"
#include "core/session/finding_text.h"
#include "core/session/section_names.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("Info", text);
}

QString length(double millimetres)
{
    return QString::number(millimetres, 'f', 1);
}

QString sizeText(const Vec2 &size)
{
    return tr("%1 × %2 mm").arg(length(size.x()), length(size.y()));
}

QString nameOf(const Model &model, int section)
{
    return QString::fromStdString(model.section(static_cast<std::size_t>(section))->name);
}

/// Steps are counted from 1 for people.
QString stepLine(const AssemblyPlan &plan, const std::vector<StepGroup> &groups, std::size_t index)
{
    const auto named = [](int step) { return QString::number(step + 1); };
    const AssemblyStep &step = plan.steps[index];
    QStringList numbers;
    for (const int part : step.parts)
        numbers += QString::number(part + 1);
    const QString number = named(static_cast<int>(index));
    const QString which = numbers.join(QStringLiteral(", "));
    if (index == 0)
        return tr("Step %1: start with part %2").arg(number, which);
    if (step.onto.empty())
        return tr("Step %1: start a group of its own with part %2").arg(number, which);
    const std::vector<int> &joins = groups[index].joins;
    return joins.empty()
               ? tr("Step %1: part %2").arg(number, which)
               : tr("Step %1: parts %2 as one, joining what steps %3 and %4 have put together")
                     .arg(number, which, named(joins.front()), named(joins.back()));
}

} // namespace

QStringList infoText(const Analysis &analysis, const std::vector<Finding> &found,
                     const InfoContext &context)
{
    const Model &model = analysis.model;
    const auto groups = heldGroups(analysis);
    const MassProperties mass = analysis.bodies.mass();
    const Box3 bounds = slabBounds(model);

    QStringList lines;
    lines += QString::fromStdString(context.file);
    lines += tr("Sections: %1").arg(model.sectionCount());
    lines += tr("Joints: %1").arg(analysis.assembly.joints.size());
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.kind == JointKind::None)
            lines += tr("%1 and %2 meet, but no slit lets them slide together.")
                         .arg(nameOf(model, joint.a), nameOf(model, joint.b));
    }
    if (groups.size() <= 1) {
        lines += tr("All sections hold together.");
    } else {
        QStringList names;
        for (std::size_t g = 1; g < groups.size(); ++g)
            for (const int section : sectionsOf(analysis.bodies, groups[g]))
                names += analysis.bodies.countOf(section) > 1
                             //: %1 is the name of a section
                             ? tr("a part of %1").arg(nameOf(model, section))
                             : nameOf(model, section);
        names.removeDuplicates();
        lines += tr("Not connected to the rest: %1").arg(inRuns(names).join(QStringLiteral(", ")));
    }
    if (!bounds.isEmpty()) {
        const Vec3 size = bounds.size();
        lines += tr("Size %1 × %2 × %3 mm (width, height, depth)")
                     .arg(length(size.x()), length(size.y()), length(size.z()));
        lines += tr("Mass %1 g").arg(QString::number(1000.0 * mass.mass, 'f', 1));
    }
    for (const Subject subject : {Subject::Stability, Subject::Assembly})
        for (const Finding &finding : found)
            if (finding.subject() == subject)
                lines += findingText(finding, model);
    for (const auto &stock : model.document.stocks) {
        lines += tr("Stock %1, %2 mm, sheets of %3")
                     .arg(QString::fromStdString(stock->name), QString::number(stock->thickness),
                          sizeText(stock->sheet));
    }
    return lines;
}

QStringList partsText(const std::vector<Part> &parts, const Model &model, const AssemblyPlan &plan)
{
    QStringList lines;
    for (const Part &part : parts) {
        QStringList joints;
        for (const Part::JointMark &mark : part.joints)
            joints += QString::number(mark.joint);
        const Box2 box = bounds(part.outline.region.outer);
        QString line = tr("Part %1: %2, %3")
                           .arg(QString::number(part.number), nameOf(model, part.section),
                                sizeText(box.size()));
        if (!joints.isEmpty())
            line += tr(", joints %1").arg(joints.join(QStringLiteral(", ")));
        lines += line;
    }
    if (lines.isEmpty())
        lines += model.sectionCount() == 0
                     ? tr("Nothing to cut: the model has no sections.")
                     : tr("Nothing to cut: the slits leave nothing of any section.");
    const std::vector<StepGroup> groups = stepGroups(plan);
    for (std::size_t i = 0; i < plan.steps.size() && plan.steps.size() > 1; ++i)
        lines += stepLine(plan, groups, i);
    return lines;
}

} // namespace fff::cli
