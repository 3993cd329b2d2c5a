#include "ui/status_line.h"

#include "ui/hint_text.h"
#include "ui/icon.h"
#include "ui/measures.h"
#include "ui/theme.h"
#include "ui/workbench.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QTextDocumentFragment>

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
        QPainter(this).fillRect(0, 2, 1, height() - 4, theme().border);
    }
};

} // namespace

StatusLine::StatusLine(Workbench &bench, QWidget *parent) : QStatusBar(parent), m_bench(bench)
{
    setObjectName(QStringLiteral("statusLine"));
    setSizeGripEnabled(false);
    setFixedHeight(kHeight);
    setContentsMargins(0, 0, 0, 0);

    auto *left = new QWidget(this);
    m_glyph = new QLabel(left);
    m_sentence = new QLabel(left);
    m_sentence->setObjectName(QStringLiteral("statusSentence"));
    m_sentence->setAccessibleName(tr("What the next gesture does"));
    m_sentence->setTextFormat(Qt::RichText);
    m_sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto *row = new QHBoxLayout(left);
    row->setContentsMargins(12, 0, 8, 0);
    row->setSpacing(8);
    row->addWidget(m_glyph);
    row->addWidget(m_sentence, 1);
    addWidget(left, 1);

    m_count = addField("statusCount", tr("Number of sections"));
    m_size = addField("statusSize", tr("Size of the model"));
    m_mass = addField("statusMass", tr("Mass of the model"));
    addField("statusUnits", tr("Units"))->setText(tr("mm"));

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
    connect(&bench.session(), &Session::modelChanged, this, &StatusLine::showNumbers);
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

void StatusLine::say(const QString &sentence)
{
    showSentence(sentence.toHtmlEscaped(), false);
    m_held.start();
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
    const bool all = width() >= kWidthForAll;
    m_size->setVisible(all);
    m_mass->setVisible(all);
}

void StatusLine::showHint()
{
    const Hint &hint = m_bench.interaction().hint();
    if (hint.isRefusal) {
        showSentence(hintSentence(hint), true);
        m_held.start();
    } else if (!m_held.isActive() || m_bench.interaction().hasGesture()) {
        m_held.stop();
        showSentence(hintSentence(hint), false);
    }
}

void StatusLine::showSentence(const QString &richText, bool isRefusal)
{
    m_isRefusal = isRefusal;
    m_sentence->setText(richText);
    m_sentence->setToolTip(QTextDocumentFragment::fromHtml(richText).toPlainText());
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
}

} // namespace fff::ui
