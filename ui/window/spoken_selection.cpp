#include "ui/window/spoken_selection.h"

#include "core/io/listing.h"
#include "core/session/check_list.h"
#include "ui/bench/load_words.h"
#include "ui/bench/workbench.h"
#include "ui/properties/stock_choice.h"

#include <QCoreApplication>

#include <algorithm>

namespace fff::ui {

namespace {

struct SpokenSelectionTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::SpokenSelection)
};

bool hasProblem(const CheckList &checks, const SectionRef &ref)
{
    return std::any_of(checks.all().begin(), checks.all().end(), [&ref](const Finding &finding) {
        return finding.severity >= Severity::Warning &&
               std::find(finding.sections.begin(), finding.sections.end(), ref) !=
                   finding.sections.end();
    });
}

QString sectionText(const Model &model, const SectionRef &ref, const CheckList &checks)
{
    const Section *section = model.find(ref);
    if (!section)
        return {};
    QStringList words{QString::fromStdString(section->name),
                      ref.drawn.isValid() ? SpokenSelectionTexts::tr("section")
                                          : SpokenSelectionTexts::tr("generated section"),
                      stockName(model.document.stockOf(*section))};
    if (section->parent && model.find(section->parent->section))
        //: %1 is the name of a section
        words += SpokenSelectionTexts::tr("on %1").arg(
            QString::fromStdString(model.nameOf(section->parent->section)));
    if (section->isLocked)
        words += SpokenSelectionTexts::tr("locked");
    words += hasProblem(checks, ref) ? SpokenSelectionTexts::tr("has a problem")
                                     : SpokenSelectionTexts::tr("no problem");
    return separated(words);
}

} // namespace

QString spokenSelection(const Workbench &bench, const CheckList &checks)
{
    const Interaction &interaction = bench.interaction();
    const Model &model = bench.session().model();
    if (const std::optional<JointRef> &joint = interaction.selectedJoint())
        return SpokenSelectionTexts::tr("Joint of %1 and %2")
            .arg(QString::fromStdString(model.nameOf(joint->a)),
                 QString::fromStdString(model.nameOf(joint->b)));
    if (const Operation *operation = model.document.find(interaction.selectedOperation()))
        return SpokenSelectionTexts::tr("%1, operation")
            .arg(QString::fromStdString(operation->name));
    if (const Load *load = model.document.find(interaction.selectedLoad()))
        //: %1 is what a weight or a push is called, %2 the name of a section
        return SpokenSelectionTexts::tr("%1 on %2")
            .arg(loadName(*load), QString::fromStdString(model.nameOf(load->section)));
    const std::vector<SectionRef> &selected = interaction.selection();
    if (selected.size() > 1)
        return SpokenSelectionTexts::tr("%n sections selected", nullptr,
                                        static_cast<int>(selected.size()));
    return selected.empty() ? QString() : sectionText(model, selected.front(), checks);
}

void speakSelection(QWidget &view, const Workbench &bench, const CheckList &checks)
{
    const auto speak = [&view, &bench, &checks, otherwise = view.accessibleDescription()] {
        const QString selected = spokenSelection(bench, checks);
        view.setAccessibleDescription(selected.isEmpty() ? otherwise : selected);
    };
    QObject::connect(&bench, &Workbench::selectionChanged, &view, speak);
    QObject::connect(&checks, &CheckList::changed, &view, speak);
}

} // namespace fff::ui
