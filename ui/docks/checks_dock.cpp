#include "ui/docks/checks_dock.h"

#include "core/assembly/joint_state.h"
#include "core/session/check_list.h"
#include "core/session/stage_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"
#include "ui/bench/workbench.h"
#include "ui/docks/check_row.h"
#include "ui/docks/dock_title.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>
#include <QTransform>
#include <QUrl>

#include <algorithm>
#include <map>

namespace fff::ui {

namespace {

constexpr int kSpinTime = 60, kSpinStep = 30; // ms, degrees

bool isProblem(const Check &check)
{
    return check.severity >= CheckSeverity::Warning;
}

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
        if (const char *stage = longWork())
            m_list.scheduler().cancel(stage);
    });
    foot->addWidget(m_stop);
    m_footer->hide();

    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_area, 1);
    column->addWidget(m_footer);
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
    connect(&bench, &Workbench::problemChosen, this, [this](int number) {
        if (const int row = rowOf(number); row >= 0) {
            Q_EMIT shown();
            choose(row, false); // the view has it in sight
        }
    });
    connect(&bench, &Workbench::problemHovered, this, [this](int number) {
        const int row = rowOf(number);
        for (std::size_t i = 0; i < m_widgets.size(); ++i)
            m_widgets[i]->setLit(static_cast<int>(i) == row);
    });
    // Without the dock there are no rows that the numbers could be of.
    connect(toggleViewAction(), &QAction::toggled, this, &ChecksDock::markProblems);
    connect(&bench, &Workbench::selectionChanged, this, [this] {
        if (!m_isChoosing)
            forgetChoice();
    });
    refresh();
}

/// The check whose row the person's keys go to, or its link.
std::optional<Check> ChecksDock::focusedCheck() const
{
    const QWidget *focus = m_area->widget()->focusWidget();
    for (std::size_t i = 0; focus && focus->hasFocus() && i < m_rows.size(); ++i)
        if (m_widgets[i] == focus || m_widgets[i]->isAncestorOf(focus))
            return m_rows[i].check;
    return {};
}

/// A row that went, or went elsewhere, left the focus to whatever came after it: to where the check
/// is now, or what became of it.
void ChecksDock::returnFocus(const Check &check)
{
    const auto rowWith = [this](auto isIt) {
        return std::find_if(m_rows.begin(), m_rows.end(),
                            [&](const Row &row) { return isIt(row.check); });
    };
    auto row = rowWith([&](const Check &now) { return isSameVerdict(check, now); });
    if (row == m_rows.end())
        row = rowWith([&](const Check &now) { return subjectOf(now) == subjectOf(check); });
    if (row == m_rows.end())
        return;
    CheckRow *widget = m_widgets[static_cast<std::size_t>(row - m_rows.begin())];
    const QWidget *focus = m_area->widget()->focusWidget();
    if (widget != focus && !(focus && widget->isAncestorOf(focus)))
        widget->setFocus();
}

void ChecksDock::refresh()
{
    const std::optional<Check> focused = focusedCheck();
    m_rows.clear();
    const std::vector<Check> &all = m_list.all();
    std::map<CheckCode, int> alike;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (alike[all[i].code]++ < kMostAlike) {
            m_rows.push_back({all[i], 1, 0, {}});
        } else {
            const auto last = std::find_if(m_rows.rbegin(), m_rows.rend(), [&](const Row &row) {
                return row.check.code == all[i].code;
            });
            last->count += 1;
            last->check.sections.insert(last->check.sections.end(), all[i].sections.begin(),
                                        all[i].sections.end());
        }
    }
    std::stable_sort(m_rows.begin(), m_rows.end(), [](const Row &a, const Row &b) {
        return a.check.severity > b.check.severity;
    });

    const bool isOlder = m_list.age() != CheckList::Age::Current;
    while (m_widgets.size() < m_rows.size()) {
        auto *row = new CheckRow(m_area->widget());
        const int index = static_cast<int>(m_widgets.size());
        row->setObjectName(QStringLiteral("checkRow%1").arg(index));
        connect(row, &CheckRow::clicked, this, [this, index] { choose(index, true); });
        connect(row, &CheckRow::hovered, this, [this, index](bool isOver) {
            const bool isThere = isOver && index < static_cast<int>(m_rows.size());
            m_bench.setLitProblem(isThere ? m_rows[static_cast<std::size_t>(index)].number : 0);
        });
        connect(row, &CheckRow::linkClicked, this, [this, index](int link) { act(index, link); });
        m_column->insertWidget(static_cast<int>(m_widgets.size()), row);
        m_widgets.push_back(row);
    }
    int number = 0;
    for (Row &row : m_rows) {
        if (isProblem(row.check))
            row.number = ++number;
    }
    bool isChosenThere = false;
    for (std::size_t i = 0; i < m_widgets.size(); ++i) {
        m_widgets[i]->setVisible(i < m_rows.size());
        if (i >= m_rows.size())
            continue;
        const Check &check = m_rows[i].check;
        CheckWords words = checkWords(check, m_list.model());
        if (m_rows[i].count > 1)
            words = {tr("%n more like this", nullptr, m_rows[i].count), QString()};
        const QColor colour = isOlder && check.severity == CheckSeverity::Good
                                  ? theme().muted
                                  : checkColour(check.severity);
        m_rows[i].actions = actionsOf(m_rows[i]);
        QStringList links;
        for (const CheckAction &action : m_rows[i].actions)
            links += actionText(action, check, m_list.model());
        m_widgets[i]->setContent({checkGlyph(check.severity), colour, severityWord(check.severity),
                                  m_rows[i].number, words.title, words.text, links, isOlder});
        const bool isChosen = m_chosen && isSameVerdict(*m_chosen, check);
        m_widgets[i]->setChecked(isChosen);
        isChosenThere = isChosenThere || isChosen;
    }
    m_empty->setVisible(m_rows.empty() && m_bench.session().model().sectionCount() == 0);
    if (focused)
        returnFocus(*focused);
    if (m_chosen && !isChosenThere)
        forgetChoice(); // it is mended
    markProblems();
    refreshFooter();
}

/// The numbers in the view. A problem without a place of its own stands where its sections are; a
/// row for many has many places, and so no number there.
void ChecksDock::markProblems()
{
    std::vector<ProblemMark> marks;
    for (const Row &row : m_rows) {
        if (row.number == 0 || row.count > 1 || !toggleViewAction()->isChecked())
            continue;
        const Check &check = row.check;
        const Model &model = m_list.model();
        Box3 box;
        for (const SectionRef &ref : check.sections) {
            if (const int index = model.indexOf(ref); index >= 0) {
                const Section &section = *model.section(static_cast<std::size_t>(index));
                box.extend(slabBounds(section, model.document.stockOf(section)));
            }
        }
        if (check.at || !box.isEmpty())
            marks.push_back({row.number, check.at ? *check.at : Vec3(box.center()), check.sections,
                             check.severity == CheckSeverity::Error});
    }
    m_bench.setProblemMarks(std::move(marks));
    showLook();
}

/// Who blocks whom is shown of the problem that is looked at: of all it would be a web of lines.
/// Whether it stands concerns the whole model, so that is seen as long as it is a problem.
void ChecksDock::showLook()
{
    ProblemLook look;
    std::vector<SectionRef> faulty;
    for (const Row &row : m_rows) {
        const Check &check = row.check;
        if (!toggleViewAction()->isChecked())
            break;
        const bool isChosen = m_chosen && isSameVerdict(*m_chosen, check);
        if (!check.support.empty() && (isProblem(check) || isChosen))
            look.grounds.push_back(
                {check.support, check.mass.centre, check.edge, check.margin, isProblem(check)});
        for (const HighFoot &foot : check.feet)
            look.feet.push_back({foot.at, foot.height});
        if (isChosen)
            for (const CheckLink &link : check.links)
                look.links.push_back({link.fromA, link.at, link.fromB, link.way});
        else if (check.severity == CheckSeverity::Error)
            faulty.insert(faulty.end(), check.sections.begin(), check.sections.end());
    }
    m_bench.setProblemLook(std::move(look), faulty);
}

int ChecksDock::rowOf(int number) const
{
    const auto row = std::find_if(m_rows.begin(), m_rows.end(),
                                  [&](const Row &r) { return number > 0 && r.number == number; });
    return row == m_rows.end() ? -1 : static_cast<int>(row - m_rows.begin());
}

void ChecksDock::refreshFooter()
{
    const CheckList::Age age = m_list.age();
    const bool isLate = age == CheckList::Age::Late;
    m_footer->setVisible(age != CheckList::Age::Current);
    const char *work = isLate ? longWork() : nullptr;
    m_stop->setVisible(work != nullptr);
    m_footerText->setText(work ? stageWork(work, m_list.scheduler().progress(work))
                               : tr("Older than the drawing"));
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
const char *ChecksDock::longWork() const
{
    for (const Stage &stage : m_list.scheduler().stages())
        if (m_list.scheduler().isRunning(stage.name))
            return stage.name;
    return nullptr;
}

void ChecksDock::refreshColours()
{
    refresh();
    for (CheckRow *row : m_widgets)
        row->refresh();
}

std::vector<int> ChecksDock::problems() const
{
    std::vector<int> rows;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (isProblem(m_rows[i].check))
            rows.push_back(static_cast<int>(i));
    }
    return rows;
}

void ChecksDock::choose(int row, bool frames)
{
    const Check check = m_rows[static_cast<std::size_t>(row)].check;
    const QScopedValueRollback choosing(m_isChoosing, true);
    m_chosen = check;
    for (std::size_t i = 0; i < m_widgets.size(); ++i)
        m_widgets[i]->setChecked(static_cast<int>(i) == row);
    // What can be done about a joint is on its page.
    if (check.joint && hasJoint(m_bench.session().committed(), *check.joint))
        m_bench.selectJoint(*check.joint);
    else
        m_bench.select(check.sections);
    m_bench.setProblemSections(isProblem(check) ? check.sections : std::vector<SectionRef>());
    showLook();
    if (frames)
        m_bench.run(check.sections.empty() ? QStringLiteral("view.fitAll")
                                           : QStringLiteral("view.fitSelection"));
    m_area->ensureWidgetVisible(m_widgets[static_cast<std::size_t>(row)], 0, 0);
}

void ChecksDock::forgetChoice()
{
    if (!m_chosen)
        return;
    m_chosen.reset();
    for (CheckRow *row : m_widgets)
        row->setChecked(false);
    m_bench.setProblemSections({});
    showLook();
}

void ChecksDock::goToProblem(int step)
{
    const std::vector<int> rows = problems();
    if (rows.empty()) {
        Q_EMIT said(m_rows.empty() ? tr("There is no section to check yet.")
                    : m_list.age() == CheckList::Age::Current
                        ? tr("There is no problem.")
                        : tr("Still checking; no problem so far."));
        return;
    }
    const int count = static_cast<int>(rows.size());
    int at = step > 0 ? -1 : count;
    for (int i = 0; i < count; ++i) {
        if (m_chosen &&
            isSameVerdict(
                *m_chosen,
                m_rows[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])].check))
            at = i;
    }
    at = ((at + step) % count + count) % count;
    const int row = rows[static_cast<std::size_t>(at)];
    choose(row, true);
    const Row &chosen = m_rows[static_cast<std::size_t>(row)];
    Q_EMIT said(tr("Problem %1 of %2: %3.")
                    .arg(at + 1)
                    .arg(count)
                    .arg(checkWords(chosen.check, m_list.model()).title.toHtmlEscaped()));
}

void ChecksDock::choose(CheckSubject subject)
{
    Q_EMIT shown();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (subjectOf(m_rows[i].check) == subject) { // the worst comes first
            choose(static_cast<int>(i), isProblem(m_rows[i].check));
            return;
        }
    }
}

/// A row for many has only what is done to all of them alike.
std::vector<CheckAction> ChecksDock::actionsOf(const Row &row) const
{
    std::vector<CheckAction> actions = m_list.actionsOf(row.check);
    if (row.count > 1)
        actions = row.check.code == CheckCode::NotConnected
                      ? std::vector<CheckAction>{{CheckAction::Kind::DeleteSections, {}}}
                      : std::vector<CheckAction>();
    return actions;
}

void ChecksDock::act(int row, int index)
{
    const Row &of = m_rows[static_cast<std::size_t>(row)];
    const CheckAction action = of.actions[static_cast<std::size_t>(index)];
    const Check check = of.check; // the rows change with the model
    switch (action.kind) {
    case CheckAction::Kind::ShowSteps:
        Q_EMIT stepsWanted();
        return;
    case CheckAction::Kind::ChooseSheet:
    case CheckAction::Kind::WidenSlits: {
        const Model &model = m_bench.session().model();
        const int at = check.sections.empty() ? -1 : model.indexOf(check.sections.front());
        Q_EMIT stockWanted(at < 0 ? StockId{} : model.section(static_cast<std::size_t>(at))->stock);
        return;
    }
    case CheckAction::Kind::TryAgain:
        m_list.scheduler().tryAgain(check.stage);
        return;
    case CheckAction::Kind::ShowReport:
        QDesktopServices::openUrl(
            QUrl::fromLocalFile(QFileInfo(m_list.reportOf(check)).absolutePath()));
        return;
    default:
        carryOut(action, check);
    }
}

/// On the model that is there now, which the row may be older than.
void ChecksDock::carryOut(const CheckAction &action, const Check &check)
{
    Session &session = m_bench.session();
    const Flips *flips = m_list.flips();
    const std::optional<CheckEdit> edit =
        session.hasPreview() ? std::nullopt
                             : carriedOut(action, check, session.currentAnalysis(), flips);
    if (!edit) {
        Q_EMIT said(tr("The model has changed; that cannot be done any more."));
        return;
    }
    const int turned = flips ? flips->count : 0;
    m_bench.commit(edit->step, edit->document);
    if (action.kind == CheckAction::Kind::MakeAssemblable)
        Q_EMIT said(turned == 1 ? tr("The slits of one joint were turned round.")
                                : tr("The slits of %n joints were turned round.", nullptr, turned));
}

} // namespace fff::ui
