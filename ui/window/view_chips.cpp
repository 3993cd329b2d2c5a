#include "ui/window/view_chips.h"

#include "core/session/scheduler.h"
#include "ui/base/theme.h"
#include "ui/bench/skin_picture.h"
#include "ui/bench/workbench.h"
#include "ui/view/heading_weight.h"

#include <QHBoxLayout>
#include <QPainter>

namespace fff::ui {

namespace {

constexpr int kChipTall = 24, kChipInside = 10, kCross = 7, kCrossGap = 8; // px
constexpr int kChipsLeft = 10, kChipsApart = 6;                            // px

} // namespace

ViewChip::ViewChip(const QString &text, const QString &tip, QWidget *parent)
    : QAbstractButton(parent)
{
    say(text, tip);
    setFocusPolicy(Qt::TabFocus); // a click leaves the focus where the hand draws
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::ArrowCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ViewChip::say(const QString &words, const QString &tip)
{
    setText(words);
    setToolTip(tip);
    setAccessibleName(words);
    setAccessibleDescription(tip);
    updateGeometry();
}

QFont ViewChip::words() const
{
    QFont f = font();
    f.setWeight(headingWeight());
    return f;
}

QSize ViewChip::sizeHint() const
{
    return {2 * kChipInside + QFontMetrics(words()).horizontalAdvance(text()) + kCrossGap + kCross,
            kChipTall};
}

void ViewChip::paintEvent(QPaintEvent *)
{
    const Theme &t = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    painter.setPen(QPen(t.accent, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(underMouse() ? t.hover : t.panel);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setPen(t.accent);
    painter.setFont(words());
    painter.drawText(rect().adjusted(kChipInside, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     text());
    const QPointF middle(width() - kChipInside - 0.5 * kCross, 0.5 * height());
    const double half = 0.5 * kCross;
    painter.setPen(QPen(t.accent, 1.6, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle - QPointF(half, half), middle + QPointF(half, half));
    painter.drawLine(middle - QPointF(half, -half), middle + QPointF(half, -half));
}

ViewChips::ViewChips(Workbench &bench, QWidget *view, int top) : QWidget(view), m_bench(bench)
{
    setObjectName(QStringLiteral("viewChips"));
    setAccessibleName(tr("How the model is shown"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kChipsApart);
    m_xray = new ViewChip(tr("X-ray"), tr("Click to see the sections as they are again."), this);
    m_xray->setObjectName(QStringLiteral("xrayChip"));
    m_cut = new ViewChip(tr("Cut open"), tr("Click to see the whole model again."), this);
    m_cut->setObjectName(QStringLiteral("cutChip"));
    m_skin = new ViewChip({}, {}, this);
    m_skin->setObjectName(QStringLiteral("skinChip"));
    for (ViewChip *chip : {m_xray, m_cut, m_skin})
        row->addWidget(chip);
    connect(m_xray, &QAbstractButton::clicked, this,
            [this] { m_bench.run(QStringLiteral("view.xray")); });
    connect(m_cut, &QAbstractButton::clicked, this,
            [this] { m_bench.run(QStringLiteral("view.clip")); });
    connect(m_skin, &QAbstractButton::clicked, this,
            [this] { m_bench.run(QStringLiteral("view.skin")); });
    move(kChipsLeft, top);
    connect(&bench, &Workbench::viewStateChanged, this, &ViewChips::refresh);
    connect(&bench.session(), &Session::modelChanged, this, &ViewChips::refresh);
    const Scheduler &scheduler = bench.session().scheduler();
    connect(&scheduler, &Scheduler::published, this, &ViewChips::refresh);
    for (const auto signal : {&Scheduler::asked, &Scheduler::progressed})
        connect(&scheduler, signal, this, &ViewChips::refresh);
    refresh();
}

void ViewChips::refreshColours()
{
    for (QWidget *chip : {m_xray, m_cut, m_skin})
        chip->update();
}

void ViewChips::refresh()
{
    const ViewState &view = m_bench.interaction().view();
    m_xray->setVisible(view.isXray);
    m_cut->setVisible(view.clip.has_value());
    const Scheduler &scheduler = m_bench.session().scheduler();
    const bool isSkinAsked = scheduler.questions().skin;
    m_skin->setVisible(isSkinAsked);
    if (const QString words = skinState(scheduler); isSkinAsked && words != m_skin->text())
        m_skin->say(words, skinDetails(scheduler));
    setVisible(view.isXray || view.clip.has_value() || isSkinAsked);
    resize(layout()->sizeHint());
}

} // namespace fff::ui
