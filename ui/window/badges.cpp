#include "ui/window/badges.h"

#include "core/interaction/view_cube.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/message_text.h"
#include "ui/bench/check_words.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/window/badge.h"

#include <QEvent>
#include <QHBoxLayout>

#include <algorithm>
#include <utility>
#include <vector>

namespace fff::ui {

namespace {

constexpr int kMargin = 10, kGap = 6; // px

/// They judge what is not made yet.
bool isDrawing(const Workbench &bench)
{
    const Overlay &overlay = bench.interaction().overlay();
    const PenMarks *path = overlay.find<PenMarks>();
    return overlay.find<sign::Stroke>() || (path && path->hasArea);
}

/// The worst that a badge speaks of; null: there is none.
const Finding *shownOf(const std::vector<Finding> &findings, Subject subject)
{
    const Finding *shown = nullptr;
    for (const Finding &finding : findings)
        if (finding.subject() == subject && finding.severity != Severity::Note &&
            (!shown || finding.severity > shown->severity))
            shown = &finding;
    return shown;
}

} // namespace

Badges::Badges(Workbench &bench, const CheckList &list, QWidget *view)
    : QWidget(view), m_bench(bench), m_list(list)
{
    setObjectName(QStringLiteral("badges"));
    setAccessibleName(tr("Verdicts"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGap);
    for (const Subject subject : kBadgeSubjects) {
        auto *badge = new Badge(this);
        badge->setObjectName(QStringLiteral("badge%1").arg(m_badges.size()));
        badge->hide();
        connect(badge, &Badge::clicked, this,
                [this, subject, badge] { Q_EMIT clicked(subject, badge->toolTip()); });
        row->addWidget(badge);
        m_badges.push_back(badge);
    }
    m_row = m_badges;
    move(kMargin, kMargin);
    view->installEventFilter(this);
    connect(&list, &CheckList::changed, this, &Badges::refresh);
    connect(&settings(), &Settings::unitChanged, this, &Badges::refresh);
    connect(&bench, &Workbench::triedChanged, this, &Badges::refresh);
    connect(&bench, &Workbench::viewChanged, this, [this] {
        if (m_isDrawing != isDrawing(m_bench))
            refresh();
    });
    refresh();
}

void Badges::refreshColours()
{
    refresh();
    for (Badge *badge : m_badges)
        badge->update();
}

bool Badges::eventFilter(QObject *object, QEvent *event)
{
    if (object == parent() && event->type() == QEvent::Resize)
        fold();
    return QWidget::eventFilter(object, event);
}

void Badges::refresh()
{
    m_isDrawing = isDrawing(m_bench);
    // Of what is only tried: which of them it would change is what it is looked at for.
    const std::vector<Finding> *tried = m_bench.findingsTried();
    for (std::size_t i = 0; i < m_badges.size(); ++i) {
        const Finding *now = shownOf(m_list.all(), kBadgeSubjects[i]);
        const Finding *shown = tried ? shownOf(*tried, kBadgeSubjects[i]) : now;
        if (shown) {
            const CheckWords words =
                checkWords(*shown, tried ? m_bench.tried()->model : m_list.model());
            const bool isChanged =
                tried && (!now || now->kind != shown->kind || now->severity != shown->severity);
            m_badges[i]->setContent({shown->severity, verdictText(*shown),
                                     QStringLiteral("%1. %2").arg(words.title, words.text),
                                     m_list.age() != CheckList::Age::Current,
                                     m_isDrawing || isChanged});
        }
        m_badges[i]->setVisible(shown != nullptr);
    }
    order();
    fold();
}

/// As the rows of the checks are (comesBefore), also of what is only tried or being drawn: a
/// verdict has one place. Badges are made in the order of the subjects.
void Badges::order()
{
    std::vector<Badge *> ordered = m_badges;
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const Badge *a, const Badge *b) { return a->severity() > b->severity(); });
    if (ordered == m_row)
        return;
    m_row = std::move(ordered);
    auto *row = static_cast<QHBoxLayout *>(layout());
    for (std::size_t i = 0; i < m_row.size(); ++i) {
        row->removeWidget(m_row[i]);
        row->insertWidget(static_cast<int>(i), m_row[i]);
        if (i > 0)
            setTabOrder(m_row[i - 1], m_row[i]);
    }
}

/// Words are there as long as they leave the view cube free: those of what is good go first, then
/// of what is less bad, from the right.
void Badges::fold()
{
    const QSize view = parentWidget()->size();
    const auto cube = cubeCentre({view.width(), view.height()});
    const double end = cube ? cube->x() - 0.5 * kCubeRoom : view.width();
    std::vector<Badge *> unfolded;
    double width = kMargin;
    for (Badge *badge : m_row) {
        badge->setFolded(false);
        if (badge->isHidden())
            continue;
        width += badge->widthWhen(false) + kGap;
        unfolded.insert(unfolded.begin(), badge);
    }
    std::stable_sort(unfolded.begin(), unfolded.end(),
                     [](const Badge *a, const Badge *b) { return a->severity() < b->severity(); });
    for (Badge *badge : unfolded) {
        if (width <= end)
            break;
        width -= badge->widthWhen(false) - badge->widthWhen(true);
        badge->setFolded(true);
    }
    const QSize size = layout()->sizeHint();
    if (this->size() != size)
        resize(size);
}

} // namespace fff::ui
