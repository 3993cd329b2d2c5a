// What the links of the Checks dock do: they are tried out while the cursor is on them, and carried
// out with a click.
#include "ui/docks/checks_dock.h"

#include "core/analysis/findings/narrow_slits.h"
#include "core/analysis/findings/not_worked_out.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/analysis/findings/strengthening.h"
#include "core/session/check_list.h"
#include "core/session/message_text.h"
#include "ui/bench/workbench.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

#include <utility>

namespace fff::ui {

/// The stock of what it is about, with the number that the link speaks of.
void ChecksDock::showStock(const Finding &finding, const ActionKind &action)
{
    const char *field = &action == &kWidenSlits    ? "stockClearance"
                        : &action == &kChooseSheet ? "stockSheetWidth"
                                                   : "stockTensile";
    const Model &model = m_bench.session().model();
    const int at = finding.sections.empty() ? -1 : model.indexOf(finding.sections.front());
    Q_EMIT stockWanted(at < 0 ? StockId{} : model.section(static_cast<std::size_t>(at))->stock,
                       QLatin1String(field));
}

/// Whether it is an edit.
bool ChecksDock::act(int row, int index)
{
    const CheckEntry::Offer &offer = entryAt(row).offers[static_cast<std::size_t>(index)];
    const FindingAction action = offer.mend.action; // the rows change with the model
    const Finding finding = offer.finding;
    if (isEdit(*action.kind)) {
        carryOut(action, finding);
        return true;
    }
    if (action.kind == &kShowSteps) {
        Q_EMIT stepsWanted();
    } else if (action.kind == &kChooseSheet || action.kind == &kWidenSlits ||
               action.kind == &kEnterStrength) {
        showStock(finding, *action.kind);
    } else if (action.kind == &kTryAgain) {
        m_list.scheduler().tryAgain(finding.details<StageFailure>()->stage);
    } else if (action.kind == &kShowReport) {
        QDesktopServices::openUrl(
            QUrl::fromLocalFile(QFileInfo(m_list.reportOf(finding)).absolutePath()));
    }
    return false;
}

/// On the model that is there now, which the row may be older than. The window does not wait until
/// that is judged.
void ChecksDock::carryOut(const FindingAction &action, const Finding &finding)
{
    m_wish = {action, finding};
    if (m_list.areMendsOf(m_bench.session().committed()))
        carryOutWish();
    else
        Q_EMIT said(tr("Still checking. This will be done as soon as the result is known."));
}

void ChecksDock::carryOutWish()
{
    const auto [action, finding] = *std::exchange(m_wish, {});
    const Mend *mend = m_bench.session().hasPreview() ? nullptr : m_list.mendFor(action, finding);
    if (!mend) {
        Q_EMIT said(tr("The model has changed; this can no longer be done."));
        return;
    }
    const FindingEdit edit = *mend->edit; // it goes with the model
    const Message changes = mend->changes;
    m_isTrying = false;
    m_bench.setTried(nullptr);
    m_bench.commit(edit.step, edit.document);
    if (!changes.isEmpty())
        //: %1 is what a link did, as it was said before: "6 joints flipped, 1 problem solved"
        return Q_EMIT said(tr("Done: %1.").arg(messageText(changes)).toHtmlEscaped());
    const Message &done = edit.said.isEmpty() ? edit.step.words : edit.said;
    Q_EMIT said(messageText(done).toHtmlEscaped());
}

void ChecksDock::tryOut(int row, int index, bool isOver)
{
    const Mend *mend = nullptr;
    if (isOver && row < static_cast<int>(m_rows.size())) {
        const std::vector<CheckEntry::Offer> &offers = entryAt(row).offers;
        if (index < static_cast<int>(offers.size()))
            mend = &offers[static_cast<std::size_t>(index)].mend;
    }
    // Over a drag, or an older row, it would show something else than it does.
    const bool isOfNow = mend && mend->tried && !m_bench.session().hasPreview() &&
                         m_list.age() == CheckList::Age::Current;
    m_bench.setTried(isOfNow ? mend->tried : nullptr);
    if (isOfNow)
        //: %1 is what a link would do, such as "6 joints flipped, 1 problem solved"
        Q_EMIT said(tr("If you click: %1.").arg(messageText(mend->changes)).toHtmlEscaped());
    else if (m_isTrying)
        Q_EMIT said(QString()); // that is over
    m_isTrying = isOfNow;
}

} // namespace fff::ui
