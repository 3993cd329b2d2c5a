#include "core/session/assembly_steps.h"

#include "core/assembly/slab.h"
#include "core/io/error_text.h"
#include "core/session/section_names.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace fff {

namespace {

struct AssemblyStepsTexts
{
    Q_DECLARE_TR_FUNCTIONS(AssemblySteps)
};

/// More names than this say less than a number does.
constexpr int kMostNames = 3;
/// A way that is off an axis of the world by more is not called by its name: cos 20°.
constexpr double kAlongAxis = 0.94;

QString nameOf(const AssemblySteps &steps, int section)
{
    const Model &model = steps.analysis->model;
    return sectionName(model, model.ref(static_cast<std::size_t>(section)));
}

/// Of a divided section a number says which of its parts is meant.
QString namesOf(const AssemblySteps &steps, const std::vector<int> &parts)
{
    if (parts.size() > kMostNames)
        return AssemblyStepsTexts::tr("%n parts as one", nullptr, static_cast<int>(parts.size()));
    QStringList names;
    for (const int part : parts) {
        const int section = steps.bodies.sectionOf(part);
        const bool isWhole = steps.bodies.countOf(section) == 1;
        const QString name = nameOf(steps, section);
        //: %1 is a section's name, %2 the number engraved on one of its parts
        names += isWhole ? name
                         : AssemblyStepsTexts::tr("%1 (part %2)")
                               .arg(name, QString::number(AssemblySteps::numberOf(part)));
    }
    return listed(inRuns(names));
}

/// Of a group that was put together aside, when that was done: a person looks for it on the table.
QString movedNames(const AssemblySteps &steps, int index)
{
    const auto &all = steps.playback.plan().steps;
    const QString names = namesOf(steps, all[static_cast<std::size_t>(index)].parts);
    const auto groupOf = [&](int step) -> const StepGroup & {
        return steps.groups[static_cast<std::size_t>(step)];
    };
    for (const int joined : groupOf(index).joins)
        if (groupOf(joined).group != groupOf(index).group)
            //: %1 is what is moved, %2 the number of the step that completed it
            return AssemblyStepsTexts::tr("%1 (together since step %2)")
                .arg(names, QString::number(joined + 1));
    return names;
}

QString matesOf(const AssemblySteps &steps, int step)
{
    const std::vector<int> &mates = steps.mates[static_cast<std::size_t>(step)];
    const int count = static_cast<int>(mates.size());
    const int named = count > kMostNames ? kMostNames - 1 : count;
    QStringList names;
    for (int i = 0; i < named; ++i)
        names += nameOf(steps, mates[static_cast<std::size_t>(i)]);
    if (named < count)
        names += AssemblyStepsTexts::tr("%n others", nullptr, count - named);
    return listed(inRuns(names));
}

/// As seen from the front.
QString wayWord(const Vec3 &direction)
{
    if (direction.y() > kAlongAxis)
        return AssemblyStepsTexts::tr("up", "direction of a way");
    if (direction.y() < -kAlongAxis)
        return AssemblyStepsTexts::tr("down", "direction of a way");
    if (direction.x() > kAlongAxis)
        return AssemblyStepsTexts::tr("to the right", "direction of a way");
    if (direction.x() < -kAlongAxis)
        return AssemblyStepsTexts::tr("to the left", "direction of a way");
    if (direction.z() > kAlongAxis)
        return AssemblyStepsTexts::tr("to the front", "direction of a way");
    if (direction.z() < -kAlongAxis)
        return AssemblyStepsTexts::tr("to the back", "direction of a way");
    return AssemblyStepsTexts::tr("along the arrow", "direction of a way");
}

/// Of each section those that joints connect it with.
std::vector<std::vector<int>> connected(const Analysis &analysis)
{
    std::vector<std::vector<int>> sections(analysis.model.sectionCount());
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.kind == JointKind::None)
            continue;
        sections[static_cast<std::size_t>(joint.a)].push_back(joint.b);
        sections[static_cast<std::size_t>(joint.b)].push_back(joint.a);
    }
    return sections;
}

/// Of each step.
std::vector<std::vector<int>> matesOf(const AssemblySteps &steps, const AssemblyPlan &plan)
{
    const std::vector<std::vector<int>> neighbours = connected(*steps.analysis);
    const Bodies &bodies = steps.bodies;
    const auto isReached = [&](int section, const AssemblyStep &step) {
        for (int part = bodies.firstOf(section); part < bodies.firstOf(section + 1); ++part)
            if (step.onto.contains(part))
                return true;
        return false;
    };
    std::vector<std::vector<int>> all;
    for (const AssemblyStep &step : plan.steps) {
        std::set<int> mates;
        for (const int part : step.parts) {
            const int moved = bodies.sectionOf(part);
            for (const int section : neighbours[static_cast<std::size_t>(moved)])
                if (isReached(section, step))
                    mates.insert(section);
        }
        all.emplace_back(mates.begin(), mates.end());
    }
    return all;
}

} // namespace

AssemblyStepsPointer assemblySteps(AnalysisPointer analysis, const ModelPlan &plan)
{
    if (plan.plan.verdict != AssemblyPlan::Verdict::Possible || plan.plan.steps.empty())
        return nullptr;
    auto steps = std::make_shared<AssemblySteps>();
    steps->analysis = std::move(analysis);
    steps->bodies = plan.bodies;
    std::vector<Box3> boxes;
    for (const Body &body : plan.bodies)
        boxes.push_back(body.box());
    steps->playback = Playback(plan.plan, std::move(boxes));
    steps->groups = stepGroups(plan.plan);
    steps->mates = matesOf(*steps, plan.plan);
    return steps;
}

QString whyNoSteps(const Analysis &analysis, const ModelPlan &plan)
{
    if (analysis.model.sectionCount() == 0)
        return AssemblyStepsTexts::tr("There is no section yet, so there are no steps.");
    switch (plan.plan.verdict) {
    case AssemblyPlan::Verdict::Possible:
        return plan.plan.steps.empty()
                   ? AssemblyStepsTexts::tr(
                         "Nothing is cut from this model, so there are no steps.")
                   : QString();
    case AssemblyPlan::Verdict::Impossible:
        break;
    case AssemblyPlan::Verdict::NotFound:
        if (plan.failure)
            //: %1 is a sentence such as "the solid of "Rib" could not be worked out"
            return AssemblyStepsTexts::tr("No steps to show: %1.")
                .arg(io::errorSentence(*plan.failure));
        return AssemblyStepsTexts::tr(
            "No steps to show: the order of assembly was not found in time.");
    }
    std::set<int> locked;
    for (const int part : plan.plan.locked)
        locked.insert(plan.bodies.sectionOf(part));
    if (locked.empty() || locked.size() > kMostNames)
        return AssemblyStepsTexts::tr(
            "No steps to show: the model cannot be assembled, since %n sections block "
            "each other.",
            nullptr, static_cast<int>(locked.size()));
    QStringList names;
    for (const int section : locked)
        names +=
            QString::fromStdString(analysis.model.section(static_cast<std::size_t>(section))->name);
    if (names.size() == 1) // parts of one section
        return AssemblyStepsTexts::tr(
                   "No steps to show: the model cannot be assembled, since parts of %1 block "
                   "each other.")
            .arg(names.front());
    return AssemblyStepsTexts::tr(
               "No steps to show: the model cannot be assembled, since %1 block each other.")
        .arg(listed(inRuns(names)));
}

QString stepTitle(const AssemblySteps &steps, int step)
{
    return AssemblyStepsTexts::tr("Step %1 of %2").arg(step + 1).arg(steps.playback.stepCount());
}

QString stepText(const AssemblySteps &steps, int index)
{
    const AssemblyStep &step = steps.playback.plan().steps[static_cast<std::size_t>(index)];
    const QString names = movedNames(steps, index);
    const std::optional<Vec3> direction = steps.playback.lastDirection(index);
    if (!direction) {
        if (index == 0)
            return AssemblyStepsTexts::tr("start with %1").arg(names);
        if (step.onto.empty()) // what is brought to the others as one, later
            return AssemblyStepsTexts::tr("start a group of its own with %1").arg(names);
        return AssemblyStepsTexts::tr("put %1 in place").arg(names);
    }
    const QString word = wayWord(*direction), mates = matesOf(steps, index);
    if (step.moves.size() > 1)
        return mates.isEmpty()
                   //: %1 is what is moved, %2 a direction such as "down"
                   ? AssemblyStepsTexts::tr("bring %1 in round the corner, finally %2")
                         .arg(names, word)
                   //: %1 is what is moved, %2 a direction such as "down", %3 what it is put into
                   : AssemblyStepsTexts::tr(
                         "bring %1 in round the corner, then slide it %2 into %3")
                         .arg(names, word, mates);
    return mates.isEmpty()
               //: %1 is what is moved, %2 a direction such as "down"
               ? AssemblyStepsTexts::tr("move %1 %2 into place").arg(names, word)
               //: %1 is what is moved, %2 a direction such as "down", %3 what it is put into
               : AssemblyStepsTexts::tr("slide %1 %2 into %3").arg(names, word, mates);
}

} // namespace fff
