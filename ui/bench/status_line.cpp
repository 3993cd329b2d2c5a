#include "ui/bench/status_line.h"

#include "ui/base/icon.h"
#include "ui/base/sentence_label.h"
#include "ui/base/theme.h"
#include "ui/bench/hint_text.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>

namespace fff::ui {

namespace {

constexpr int kHeight = 28;        // px
constexpr int kHoldTime = 6000;    // ms
constexpr int kWidthForAll = 1100; // px; below it size and mass give way to the sentence

/// One of the numbers at the right, with a line before it.
class Field : public QLabel
{
public:
    using QLabel::QLabel;

protected:
    void paintEvent(QPaintEvent *event) override
    {
        QLabel::paintEvent(event);
        QPainter(this).fillRect(0, 4, 1, height() - 8, theme().border);
    }
};

} // namespace

StatusLine::StatusLine(Workbench &bench, KeysOf keysOf, QWidget *parent)
    : QStatusBar(parent), m_bench(bench), m_keysOf(std::move(keysOf))
{
    setObjectName(QStringLiteral("statusLine"));
    setSizeGripEnabled(false);
    setFixedHeight(kHeight);
    setContentsMargins(0, 0, 0, 0);

    auto *left = new QWidget(this);
    m_glyph = new QLabel(left);
    m_sentence = new SentenceLabel(left);
    m_sentence->setObjectName(QStringLiteral("statusSentence"));
    m_sentence->setAccessibleName(tr("What the next gesture does"));
    auto *row = new QHBoxLayout(left);
    row->setContentsMargins(12, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(m_glyph);
    row->addWidget(m_sentence, 1);
    addWidget(left, 1);

    m_count = addField("statusCount", tr("Number of sections"));
    m_size = addField("statusSize", tr("Size of the model"));
    m_mass = addField("statusMass", tr("Mass of the model"));
    addPermanentWidget(makeUnits());

    m_held.setSingleShot(true);
    m_held.setInterval(kHoldTime);
    connect(&m_held, &QTimer::timeout, this, &StatusLine::showHint);
    connect(&bench, &Workbench::hintChanged, this, &StatusLine::showHint);
    connect(&bench, &Workbench::viewChanged, this, [this] {
        if (m_held.isActive() && m_bench.interaction().hasGesture()) {
            m_held.stop();
            showHint();
        }
    });
    connect(&bench.session(), &Session::modelChanged, this, [this] {
        if (m_isOfHistory)
            endSaid();
        showNumbers();
    });
    // Who takes up a tool has read it.
    connect(&bench, &Workbench::viewStateChanged, this, [this] {
        const void *tool = m_bench.interaction().tool();
        if (m_held.isActive() && tool && tool != m_saidWith)
            endSaid();
    });
    connect(&bench.session(), &Session::analysisChanged, this, &StatusLine::showNumbers);
    showHint();
    showNumbers();
}

QLabel *StatusLine::addField(const char *objectName, const QString &name)
{
    auto *field = new Field(this);
    field->setObjectName(QLatin1String(objectName));
    field->setAccessibleName(name);
    field->setToolTip(name);
    field->setProperty("statusField", true);
    addPermanentWidget(field);
    return field;
}

/// A menu: what is shown here is what all lengths are shown in.
QWidget *StatusLine::makeUnits()
{
    m_units = new QToolButton(this);
    m_units->setObjectName(QStringLiteral("statusUnits"));
    m_units->setAccessibleName(tr("Units"));
    m_units->setToolTip(tr("Unit of all lengths"));
    m_units->setPopupMode(QToolButton::InstantPopup);
    m_units->setFocusPolicy(Qt::TabFocus);
    auto *menu = new QMenu(m_units);
    auto *group = new QActionGroup(menu);
    for (LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch}) {
        QAction *action =
            menu->addAction(QStringLiteral("%1 (%2)").arg(unitName(unit), unitSign(unit)));
        action->setCheckable(true);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [unit] { settings().setUnit(unit); });
        const auto follow = [action, unit] { action->setChecked(settings().unit() == unit); };
        connect(&settings(), &Settings::unitChanged, action, follow);
        follow();
    }
    m_units->setMenu(menu);
    connect(&settings(), &Settings::unitChanged, this, &StatusLine::showNumbers);
    return m_units;
}

void StatusLine::say(const QString &sentence)
{
    sayMarked(sentence.toHtmlEscaped());
}

void StatusLine::sayMarked(const QString &sentence)
{
    if (sentence.isEmpty()) {
        m_held.stop();
        showHint();
        return;
    }
    m_isOfHistory = false;
    m_saidWith = m_bench.interaction().tool();
    showSentence(sentence, false);
    m_held.start();
}

void StatusLine::endSaid()
{
    m_isOfHistory = false;
    m_held.stop();
    showHint();
}

void StatusLine::setStanding(const QString &sentence)
{
    m_standing = sentence;
    m_held.stop();
    showHint();
}

void StatusLine::setElsewhere(const QString &marked)
{
    if (m_elsewhere == marked)
        return;
    m_elsewhere = marked;
    showHint();
}

void StatusLine::sayUndone(const QString &step)
{
    const QString name = step.toHtmlEscaped(), keys = m_keysOf("edit.redo").toHtmlEscaped();
    sayMarked(keys.isEmpty()
                  ? tr("Undid \u201c%1\u201d.").arg(name)
                  : tr("Undid \u201c%1\u201d. <kbd>%2</kbd> brings it back.").arg(name, keys));
    m_isOfHistory = true;
}

void StatusLine::sayRedone(const QString &step)
{
    const QString name = step.toHtmlEscaped(), keys = m_keysOf("edit.undo").toHtmlEscaped();
    sayMarked(keys.isEmpty() ? tr("Redid “%1”.").arg(name)
                             : tr("Redid “%1”. <kbd>%2</kbd> takes it back.").arg(name, keys));
    m_isOfHistory = true;
}

void StatusLine::refresh()
{
    m_glyph->setPixmap(tintedPixmap(m_isRefusal ? QStringLiteral("warn") : QStringLiteral("mouse"),
                                    16, m_isRefusal ? theme().warning : theme().accent,
                                    devicePixelRatioF()));
}

void StatusLine::resizeEvent(QResizeEvent *event)
{
    QStatusBar::resizeEvent(event);
    showFields();
}

/// What an empty model measures is nothing to be told.
void StatusLine::showFields()
{
    const bool isThere = m_bench.session().model().sectionCount() > 0;
    const bool all = isThere && width() >= kWidthForAll;
    m_count->setVisible(isThere);
    m_size->setVisible(all);
    m_mass->setVisible(all);
}

void StatusLine::showHint()
{
    const Hint &hint = m_bench.interaction().hint();
    if (!m_standing.isEmpty()) {
        if (!m_held.isActive())
            showSentence(m_standing.toHtmlEscaped(), false);
    } else if (hint.isRefusal) {
        showSentence(hintSentence(hint, m_keysOf("edit.undo")), true);
        m_held.start();
    } else if (!m_held.isActive() || m_bench.interaction().hasGesture()) {
        m_held.stop();
        showSentence(
            m_elsewhere.isEmpty() ? hintSentence(hint, m_keysOf("edit.undo")) : m_elsewhere, false);
    }
}

void StatusLine::showSentence(const QString &marked, bool isRefusal)
{
    m_isRefusal = isRefusal;
    m_sentence->setSentence(marked);
    refresh();
}

void StatusLine::showNumbers()
{
    const Measures measures(m_bench.session());
    const Vec3 size = measures.size();
    m_count->setText(
        tr("%n section(s)", nullptr, static_cast<int>(m_bench.session().model().sectionCount())));
    m_size->setText(sizeText({size.x(), size.y(), size.z()}, 0, locale()));
    m_mass->setText(massText(measures.mass(), locale()));
    m_units->setText(unitSign(settings().unit()));
    showFields();
}

} // namespace fff::ui
