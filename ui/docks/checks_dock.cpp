#include "ui/docks/checks_dock.h"

#include "core/analysis/findings/doubted_verdicts.h"
#include "core/assembly/joint_state.h"
#include "core/session/check_list.h"
#include "core/session/message_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"
#include "ui/bench/workbench.h"
#include "ui/docks/check_row.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/shown_problems.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QTransform>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kSpinTime = 60, kSpinStep = 30; // ms, degrees

} // namespace

ChecksDock::ChecksDock(Workbench &bench, const CheckList &list, QWidget *parent)
    : QDockWidget(tr("Checks"), parent), m_bench(bench), m_list(list)
{
    dressDock(this, "checksDock");
    auto *content = new QWidget(this);
    m_area = new QScrollArea(content);
    m_area->setObjectName(QStringLiteral("checksArea"));
    m_area->setAccessibleName(tr("Checks"));
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setWidgetResizable(true);
    m_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_area->setFocusPolicy(Qt::NoFocus);
    // The link goes from under the cursor, and no event says so.
    connect(m_area->verticalScrollBar(), &QScrollBar::valueChanged, this,
            [this] { tryOut(0, 0, false); });
    auto *rows = new QWidget(m_area);
    rows->setObjectName(QStringLiteral("checksRows"));
    rows->setBackgroundRole(QPalette::Base);
    rows->setAutoFillBackground(true);
    m_column = new QVBoxLayout(rows);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    m_empty = new QLabel(tr("Checks begin with the first section."), rows);
    m_empty->setObjectName(QStringLiteral("checksEmpty"));
    m_empty->setWordWrap(true);
    m_empty->setMargin(12);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_column->addWidget(m_empty);
    m_column->addStretch(1);
    m_area->setWidget(rows);

    m_footer = new QWidget(content);
    m_spinner = new QLabel(m_footer);
    m_footerText = new QLabel(m_footer);
    m_footerText->setTextFormat(Qt::PlainText);
    m_footerText->setWordWrap(true); // what is worked out is said to its end
    m_footerText->setObjectName(QStringLiteral("checksFooter"));
    m_footerText->setForegroundRole(QPalette::PlaceholderText);
    QFont italic = font();
    italic.setItalic(true);
    m_footerText->setFont(italic);
    auto *foot = new QHBoxLayout(m_footer);
    foot->setContentsMargins(12, 3, 12, 4);
    foot->setSpacing(8);
    foot->addWidget(m_spinner);
    foot->addWidget(m_footerText, 1);
    m_stop = new QToolButton(m_footer);
    m_stop->setObjectName(QStringLiteral("checksStop"));
    m_stop->setText(tr("Stop"));
    m_stop->setAutoRaise(true);
    connect(m_stop, &QToolButton::clicked, this, [this] {
        if (const Stage *stage = longWork())
            m_list.scheduler().cancel(stage->name);
    });
    foot->addWidget(m_stop);
    content->setBackgroundRole(QPalette::Base);
    content->setAutoFillBackground(true);
    // Over the rows: those that move each time something is worked out are hard to read, and to
    // hit, and room that is kept for it is lost all the rest of the time.
    m_footer->setBackgroundRole(QPalette::Base);
    m_footer->setAutoFillBackground(true);
    m_footer->hide();

    auto *cell = new QGridLayout(content);
    cell->setContentsMargins(0, 0, 0, 0);
    cell->addWidget(m_area, 0, 0);
    cell->addWidget(m_footer, 0, 0, Qt::AlignBottom);
    setWidget(content);
    content->setMinimumHeight(92);

    m_spin = new QTimer(this);
    m_spin->setInterval(kSpinTime);
    connect(m_spin, &QTimer::timeout, this, [this] {
        m_angle = (m_angle + kSpinStep) % 360;
        const QPixmap still =
            tintedPixmap(QStringLiteral("working"), 16, theme().muted, devicePixelRatioF());
        QPixmap turned = still.transformed(QTransform().rotate(m_angle), Qt::SmoothTransformation);
        // The turned picture is larger; what was in the middle stays there.
        const QSize size(static_cast<int>(16 * devicePixelRatioF()),
                         static_cast<int>(16 * devicePixelRatioF()));
        turned = turned.copy((turned.width() - size.width()) / 2,
                             (turned.height() - size.height()) / 2, size.width(), size.height());
        turned.setDevicePixelRatio(devicePixelRatioF());
        m_spinner->setPixmap(turned);
    });
    connect(&list, &CheckList::changed, this, &ChecksDock::refresh);
    connect(&list.scheduler(), &Scheduler::progressed, this, &ChecksDock::refreshFooter);
    connect(&settings(), &Settings::unitChanged, this, &ChecksDock::refresh);
    connect(&bench.session(), &Session::modelChanged, this,
            [this](const Model &before, const Model &after) {
                if (before.sectionCount() == 0 || after.sectionCount() == 0)
                    refresh(); // whether there is anything to check
            });
    connect(&bench, &Workbench::problemChosen, this, [this](int number, int place) {
        if (const int row = rowOf(number); row >= 0) {
            Q_EMIT shown();
            entryAt(row).place = std::clamp(place, 0, entryAt(row).count() - 1);
            choose(row, false); // the view has it in sight
        }
    });
    connect(&bench, &Workbench::problemHovered, this, [this](int number) {
        const int row = rowOf(number);
        for (std::size_t i = 0; i < m_widgets.size(); ++i)
            m_widgets[i]->setLit(static_cast<int>(i) == row);
        showLook();
    });
    connect(&bench.session(), &Session::committedChanged, this, [this] { m_wish.reset(); });
    // Without the dock there are no rows that the numbers could be of.
    connect(toggleViewAction(), &QAction::toggled, this, &ChecksDock::markProblems);
    connect(&bench, &Workbench::selectionChanged, this, [this] {
        if (!m_isChoosing)
            forgetChoice();
    });
    refresh();
}

/// The finding whose row the person's keys go to, or its link.
std::optional<Finding> ChecksDock::focusedFinding() const
{
    const QWidget *focus = m_area->widget()->focusWidget();
    for (std::size_t i = 0; focus && focus->hasFocus() && i < m_rows.size(); ++i)
        if (m_widgets[i] == focus || m_widgets[i]->isAncestorOf(focus))
            return m_rows[i].finding();
    return {};
}

/// A row that went, or went elsewhere, left the focus to whatever came after it: to where the check
/// is now, or what became of it.
void ChecksDock::returnFocus(const Finding &finding)
{
    const auto rowWith = [this](auto isIt) {
        return std::find_if(m_rows.begin(), m_rows.end(),
                            [&](const CheckEntry &row) { return isIt(row.finding()); });
    };
    auto row = rowWith([&](const Finding &now) { return isSameVerdict(finding, now); });
    if (row == m_rows.end())
        row = rowWith([&](const Finding &now) { return now.subject() == finding.subject(); });
    if (row == m_rows.end())
        return;
    CheckRow *widget = m_widgets[static_cast<std::size_t>(row - m_rows.begin())];
    const QWidget *focus = m_area->widget()->focusWidget();
    if (widget != focus && !(focus && widget->isAncestorOf(focus)))
        widget->setFocus();
}

void ChecksDock::refresh()
{
    const std::optional<Finding> focused = focusedFinding();
    m_bench.setTried(nullptr); // it was tried on what was there before
    m_rows = checkEntries(m_list, m_rows);
    while (m_widgets.size() < m_rows.size()) {
        auto *row = new CheckRow(m_area->widget());
        const int index = static_cast<int>(m_widgets.size());
        row->setObjectName(QStringLiteral("checkRow%1").arg(index));
        connect(row, &CheckRow::clicked, this, [this, index] { click(index); });
        connect(row, &CheckRow::hovered, this, [this, index](bool isOver) {
            const bool isThere = isOver && index < static_cast<int>(m_rows.size());
            m_bench.setLitProblem(isThere ? entryAt(index).number : 0);
            showLook();
        });
        connect(row, &CheckRow::linkClicked, this, [this, index](int link, bool isByKey) {
            // Who works with keys goes on with the next check.
            const bool isEdited = act(index, link);
            if (isEdited && !isByKey)
                Q_EMIT viewWanted();
        });
        connect(row, &CheckRow::linkHovered, this,
                [this, index](int link, bool isOver) { tryOut(index, link, isOver); });
        m_column->insertWidget(static_cast<int>(m_widgets.size()), row);
        m_widgets.push_back(row);
    }
    bool isChosenThere = false;
    for (std::size_t i = 0; i < m_widgets.size(); ++i) {
        m_widgets[i]->setVisible(i < m_rows.size());
        if (i >= m_rows.size())
            continue;
        m_widgets[i]->setContent(contentOf(m_rows[i], m_list));
        const bool isChosen = m_chosen && m_rows[i].placeOf(*m_chosen) >= 0;
        m_widgets[i]->setChecked(isChosen);
        isChosenThere = isChosenThere || isChosen;
    }
    m_empty->setVisible(m_rows.empty() && m_bench.session().model().sectionCount() == 0);
    layRowsOut();
    if (focused)
        returnFocus(*focused);
    if (m_chosen && !isChosenThere)
        forgetChoice(); // it is mended
    markProblems();
    refreshFooter();
    if (m_wish && m_list.areMendsOf(m_bench.session().committed()))
        carryOutWish();
}

/// At once: rows that wait for their places, while the view is drawn, lie over each other until
/// then.
void ChecksDock::layRowsOut()
{
    m_column->activate();
    QEvent wanted(QEvent::LayoutRequest); // the area follows
    QCoreApplication::sendEvent(m_area->widget(), &wanted);
}

/// In the view; without the dock there are no rows that they could be of.
void ChecksDock::markProblems()
{
    m_bench.setProblemMarks(toggleViewAction()->isChecked()
                                ? marksOf(m_rows, m_list.model(), m_chosen)
                                : std::vector<ProblemMark>());
    showLook();
}

void ChecksDock::showLook()
{
    ShownProblems shown; // without the dock there are no rows that they could be of
    if (toggleViewAction()->isChecked())
        shown = shownProblems(m_rows, m_list.model(), m_chosen, litFinding());
    m_bench.setProblemLook(std::move(shown.look), shown.hatched, shown.outlined, shown.doubtful);
}

/// That the cursor is on, in its row or at its mark; null: on none.
const Finding *ChecksDock::litFinding() const
{
    const Hovered &hovered = m_bench.interaction().hovered();
    const bool isMark = hovered.problem > 0;
    const int row = rowOf(isMark ? hovered.problem : m_bench.litProblem());
    if (row < 0)
        return nullptr;
    const CheckEntry &entry = m_rows[static_cast<std::size_t>(row)];
    return isMark && hovered.problemPlace >= 0 && hovered.problemPlace < entry.count()
               ? &entry.row.all[static_cast<std::size_t>(hovered.problemPlace)]
               : &entry.finding();
}

int ChecksDock::rowOf(int number) const
{
    const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const CheckEntry &r) {
        return number > 0 && r.number == number;
    });
    return row == m_rows.end() ? -1 : static_cast<int>(row - m_rows.begin());
}

void ChecksDock::refreshFooter()
{
    const CheckList::Age age = m_list.age();
    const bool isLate = age == CheckList::Age::Late;
    m_footer->setVisible(age != CheckList::Age::Current);
    const Stage *work = isLate ? longWork() : nullptr;
    m_stop->setVisible(work != nullptr);
    const QString words = work ? messageText(workOf(*work, m_list.scheduler().progress(work->name)))
                          : m_rows.empty() ? tr("Checking\u2026")
                                           : tr("Older than the drawing");
    m_footerText->setText(words);
    m_spinner->setVisible(work != nullptr);
    const bool spins = work && !settings().reducesMotion();
    if (spins && !m_spin->isActive())
        m_spin->start();
    else if (!spins)
        m_spin->stop();
    if (work && !spins)
        m_spinner->setPixmap(
            tintedPixmap(QStringLiteral("working"), 16, theme().muted, devicePixelRatioF()));
}

/// What a person waits for: of several stages that run the first one.
const Stage *ChecksDock::longWork() const
{
    for (const Stage &stage : m_list.scheduler().stages())
        if (m_list.scheduler().isRunning(stage.name))
            return &stage;
    return nullptr;
}

void ChecksDock::refreshColours()
{
    refresh();
    for (CheckRow *row : m_widgets)
        row->refresh();
}

std::vector<std::pair<int, int>> ChecksDock::problems() const
{
    std::vector<std::pair<int, int>> all;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        for (int place = 0; m_rows[i].number > 0 && place < m_rows[i].count(); ++place)
            all.emplace_back(static_cast<int>(i), place);
    return all;
}

void ChecksDock::click(int row)
{
    CheckEntry &entry = entryAt(row);
    if (const int chosen = m_chosen ? entry.placeOf(*m_chosen) : -1; chosen >= 0)
        entry.place = (chosen + 1) % entry.count();
    choose(row, true);
}

void ChecksDock::choose(int row, bool frames)
{
    const Finding finding = entryAt(row).finding();
    const QScopedValueRollback choosing(m_isChoosing, true);
    m_chosen = finding;
    Q_EMIT chosenChanged(m_chosen);
    for (std::size_t i = 0; i < m_widgets.size(); ++i)
        m_widgets[i]->setChecked(static_cast<int>(i) == row);
    // Of a verdict that is doubted there is nothing to look at but what the doubt is about.
    const Finding *doubter = doubterOf(finding, m_list.all());
    const Finding about = doubter ? *doubter : finding;
    // What can be done about a joint is on its page.
    if (about.joint && hasJoint(m_bench.session().committed(), *about.joint))
        m_bench.selectJoint(*about.joint);
    else
        m_bench.select(about.sections);
    if (entryAt(row).count() > 1)
        refresh(); // it says which of its places this is
    else
        markProblems();
    if (frames && about.sections.empty())
        m_bench.run(QStringLiteral("view.fitAll"));
    else if (frames) // half of the view is for what is round it
        m_bench.run(QStringLiteral("view.fitSelection"), {{"share", "0.5"}});
    m_area->ensureWidgetVisible(m_widgets[static_cast<std::size_t>(row)], 0, 0);
}

void ChecksDock::forgetChoice()
{
    if (!m_chosen)
        return;
    m_chosen.reset();
    Q_EMIT chosenChanged(m_chosen);
    for (CheckRow *row : m_widgets)
        row->setChecked(false);
    markProblems();
}

void ChecksDock::goToProblem(int step)
{
    const std::vector<std::pair<int, int>> all = problems();
    if (all.empty()) {
        Q_EMIT said(m_rows.empty() ? tr("There is no section to check yet.")
                    : m_list.age() == CheckList::Age::Current
                        ? tr("No problems.")
                        : tr("Still checking; no problems so far."));
        return;
    }
    const int count = static_cast<int>(all.size());
    int at = step > 0 ? -1 : count;
    for (int i = 0; m_chosen && i < count; ++i) {
        const auto [row, place] = all[static_cast<std::size_t>(i)];
        if (entryAt(row).placeOf(*m_chosen) == place)
            at = i;
    }
    at = ((at + step) % count + count) % count;
    const auto [row, place] = all[static_cast<std::size_t>(at)];
    entryAt(row).place = place;
    choose(row, true);
    // By rows, as they are numbered.
    int number = 0, rows = 0, places = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        rows += i == 0 || all[i].first != all[i - 1].first ? 1 : 0;
        number = all[i].first == row && number == 0 ? rows : number;
        places += all[i].first == row ? 1 : 0;
    }
    const QString title = checkWords(entryAt(row).finding(), m_list.model()).title.toHtmlEscaped();
    Q_EMIT said(places == 1
                    ? tr("Problem %1 of %2: %3.").arg(number).arg(rows).arg(title)
                    //: %3 and %4 are a place of several that have the same problem, %5 is its title
                    : tr("Problem %1 of %2, place %3 of %4: %5.")
                          .arg(number)
                          .arg(rows)
                          .arg(place + 1)
                          .arg(places)
                          .arg(title));
}

void ChecksDock::choose(Subject subject)
{
    Q_EMIT shown();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].finding().subject() == subject) { // the worst comes first
            choose(static_cast<int>(i), isProblem(m_rows[i].finding()));
            return;
        }
    }
}

void ChecksDock::choose(const Finding &finding)
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const int place = m_rows[i].placeOf(finding);
        if (place < 0)
            continue;
        m_rows[i].place = place;
        Q_EMIT shown();
        return choose(static_cast<int>(i), true);
    }
    choose(finding.subject());
}

} // namespace fff::ui
