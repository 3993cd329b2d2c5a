// Every page, bar and dialog in each theme: what is written stands out from what is painted behind
// it as WCAG 2.1 AA wants it. Which words there are and their colours say their own paint calls;
// what is behind them the pixels.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/contrast.h"
#include "tests/ui/every_page.h"
#include "tests/ui/painted_words.h"

#include <QAbstractItemView>
#include <QLabel>
#include <QMenuBar>

#include <map>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

constexpr QSize kUsualSize(1440, 900);
constexpr double kOfText = 4.5, kOfLargeText = 3.0;
constexpr double kLarge = 24.0, kLargeBold = 18.66; // px of the letters' em
constexpr int kPatience = 30;                       // ms, until all is painted

/// The commonest colour there besides that of the words, unless all of it has that.
QColor behind(const QImage &picture, const QRect &box, const QColor &words)
{
    std::map<QRgb, int> counts;
    for (int y = box.top(); y <= box.bottom(); ++y)
        for (int x = box.left(); x <= box.right(); ++x)
            ++counts[picture.pixel(x, y)];
    if (counts.size() > 1)
        counts.erase(words.rgb());
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto &a, const auto &b) { return a.second < b.second; });
    return most == counts.end() ? QColor() : QColor(most->first);
}

QColor over(const QColor &colour, const QColor &ground)
{
    const float a = colour.alphaF();
    return QColor::fromRgbF(a * colour.redF() + (1.0F - a) * ground.redF(),
                            a * colour.greenF() + (1.0F - a) * ground.greenF(),
                            a * colour.blueF() + (1.0F - a) * ground.blueF());
}

bool isLarge(const QFont &font)
{
    const double px = QFontInfo(font).pixelSize();
    return px >= kLarge || (px >= kLargeBold && font.weight() >= QFont::Bold);
}

/// What can do nothing now may be faint (WCAG 1.4.3, inactive).
bool isInactive(const QWidget &at, const QPoint &place)
{
    if (!at.isEnabled())
        return true;
    if (const auto *bar = qobject_cast<const QMenuBar *>(&at)) {
        const QAction *action = bar->actionAt(bar->mapFrom(bar->window(), place));
        return action && !action->isEnabled();
    }
    const auto *view = qobject_cast<const QAbstractItemView *>(at.parentWidget());
    if (!view)
        return false;
    const QModelIndex index = view->indexAt(at.mapFrom(at.window(), place));
    return index.isValid() && !index.flags().testFlag(Qt::ItemIsEnabled);
}

} // namespace

class TestContrast : public QObject, private EveryPage
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_faint.clear();
        m_count = 0;
    }
    void cleanup() { closeAll(); }

    void itIsMeasured();
    void wordsStandOut_data();
    void wordsStandOut();

private:
    using EveryPage::look;
    void look(const QString &state, QWidget &top) override;

    std::map<QString, QString> m_faint; // what cannot be read well, and where it was seen first
    int m_count = 0;                    // of words that were looked at
};

void TestContrast::look(const QString &state, QWidget &top)
{
    unfold(top);
    QTest::qWait(kPatience);
    const QImage picture = top.grab().toImage();
    for (const PaintedWords &words : paintedWords(top)) {
        const QRect box = words.box.toAlignedRect() & picture.rect();
        const QWidget *at = top.childAt(box.center());
        const bool isSign = std::none_of(words.text.begin(), words.text.end(),
                                         [](QChar c) { return c.isLetterOrNumber(); });
        if (isSign || box.isEmpty() || !at || isInactive(*at, box.center()))
            continue;
        ++m_count;
        const QColor ground = behind(picture, box, words.colour);
        const double ratio = contrast(over(words.colour, ground), ground);
        if (ratio < (isLarge(words.font) ? kOfLargeText : kOfText))
            m_faint.emplace(QStringLiteral("“%1” in %2 of %3: %4 on %5, %6 : 1")
                                .arg(words.text.left(40),
                                     QLatin1String(at->metaObject()->className()), at->objectName(),
                                     words.colour.name(QColor::HexArgb), ground.name())
                                .arg(ratio, 0, 'f', 2),
                            state);
    }
}

// What it finds is there, and what is faint is found.
void TestContrast::itIsMeasured()
{
    openWith(QStringLiteral("en"), kUsualSize);
    QWidget page(nullptr);
    page.resize(300, 100);
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(0xff, 0xff, 0xff));
    palette.setColor(QPalette::WindowText, QColor(0x99, 0x99, 0x99)); // 2.85 : 1
    page.setPalette(palette);
    page.setAutoFillBackground(true);
    auto *faint = new QLabel(QStringLiteral("Faint"), &page);
    faint->setPalette(palette);
    faint->setGeometry(10, 10, 200, 20);
    auto *clear = new QLabel(QStringLiteral("Clear"), &page);
    palette.setColor(QPalette::WindowText, QColor(0x70, 0x70, 0x70)); // 4.95 : 1
    clear->setPalette(palette);
    clear->setGeometry(10, 40, 200, 20);
    page.show();
    look(QStringLiteral("made"), page);
    QCOMPARE(m_count, 2);
    QCOMPARE(m_faint.size(), std::size_t(1));
    QVERIFY(m_faint.begin()->first.contains(QStringLiteral("Faint")));
}

void TestContrast::wordsStandOut_data()
{
    QTest::addColumn<int>("scheme");
    QTest::newRow("light") << static_cast<int>(ColourScheme::Light);
    QTest::newRow("dark") << static_cast<int>(ColourScheme::Dark);
    QTest::newRow("high contrast") << static_cast<int>(ColourScheme::HighContrast);
}

void TestContrast::wordsStandOut()
{
    QFETCH(int, scheme);
    openWith(QStringLiteral("en"), kUsualSize);
    settings().setColourScheme(static_cast<ColourScheme>(scheme));
    QTest::qWait(kPatience);
    showPages();
    showOperations();
    showDialogs();
    for (const auto &[words, state] : m_faint)
        qWarning("%s: %s", qPrintable(state), qPrintable(words));
    QVERIFY2(m_faint.empty(), qPrintable(QStringLiteral("%1 are faint").arg(m_faint.size())));
    QVERIFY(m_count > 1000); // all pages were looked at
}

FFF_TEST_WITH(TestContrast, runOnLargeScreen<TestContrast>)
#include "tst_contrast.moc"
