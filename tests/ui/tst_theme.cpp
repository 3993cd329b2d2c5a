// What stands on what can be read: contrasts as WCAG 2.1 reckons them.
#include <QTest>

#include "tests/test_program.h"
#include "tests/ui/contrast.h"
#include "ui/base/field_style.h"
#include "ui/base/file_dialog.h"
#include "ui/base/theme.h"
#include "ui/settings/settings.h"
#include "ui/view/heading_weight.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyleOptionButton>
#include <QTemporaryDir>
#include <QWidget>

using namespace fff::test;
using namespace fff::ui;

class TestTheme : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        Settings::setFile(m_folder.filePath(QStringLiteral("settings.ini")));
    }

    void everyTextCanBeRead_data()
    {
        QTest::addColumn<int>("scheme");
        QTest::addColumn<bool>("isSystemDark");
        QTest::addColumn<double>("least");
        QTest::newRow("light") << static_cast<int>(ColourScheme::Light) << false << 4.5;
        QTest::newRow("dark") << static_cast<int>(ColourScheme::Dark) << false << 4.5;
        QTest::newRow("high contrast, light")
            << static_cast<int>(ColourScheme::HighContrast) << false << 7.0;
        QTest::newRow("high contrast, dark")
            << static_cast<int>(ColourScheme::HighContrast) << true << 7.0;
    }

    /// Who chose high contrast would still meet grey on grey, or an edge that cannot be seen.
    void everyTextCanBeRead()
    {
        QFETCH(int, scheme);
        QFETCH(bool, isSystemDark);
        QFETCH(double, least);
        use(scheme, isSystemDark);
        const Theme &t = theme();
        const bool isContrast = least > 5.0;
        QCOMPARE(t.isHighContrast, isContrast);
        if (isContrast)
            QCOMPARE(t.isDark, isSystemDark);

        struct Pair
        {
            const char *name;
            QColor line, ground;
            double least;
        };
        const ViewStyle v = t.viewStyle();
        // On the ground that is lit, marks other than text need less in the usual themes.
        const double mark = isContrast ? 7.0 : 3.0;
        const Pair pairs[] = {
            {"text on the window", t.text, t.window, least},
            {"text on a panel", t.text, t.panel, least},
            {"text on every other row", t.text, t.alternate, least},
            {"text on a button", t.text, t.button, least},
            {"text on a hovered row", t.text, t.hover, least},
            {"text on a chosen check", t.text, t.soft, least},
            {"muted on the window", t.muted, t.window, least},
            {"muted on a panel", t.muted, t.panel, least},
            {"muted on a hovered row", t.muted, t.hover, least},
            {"muted on a chosen check", t.muted, t.soft, least},
            {"a selected row", t.onAccent, t.accent, least},
            {"a checked tool", t.accent, t.soft, isContrast ? 7.0 : 4.5},
            {"the focus on a panel", t.accent, t.panel, mark},
            {"the focus on the window", t.accent, t.window, mark},
            {"a field's border", t.strong, t.window, mark},
            {"a problem", t.problem, t.panel, least},
            {"a problem in a bar", t.problem, t.problemSoft, least},
            {"text in a bar of problems", t.text, t.problemSoft, least},
            {"a warning", t.warning, t.panel, least},
            {"a warning in a bar", t.warning, t.warningSoft, least},
            {"good", t.good, t.panel, least},
            {"the number of a problem", v.panel, v.problem, least},
            {"the number of a warning", v.panel, v.warning, least},
            {"words in the view, above", v.muted, v.top, least},
            {"words in the view, below", v.muted, v.bottom, least},
            {"the slit in its casing", v.slit, v.panel, mark},
            {"a problem's outline", v.problem, isContrast ? v.bottom : v.top, mark},
        };
        for (const Pair &pair : pairs)
            QVERIFY2(contrast(pair.line, pair.ground) >= pair.least - 1e-9,
                     qPrintable(QStringLiteral("%1: %2 to 1")
                                    .arg(QLatin1String(pair.name))
                                    .arg(contrast(pair.line, pair.ground))));
        if (!isContrast)
            return;
        // In the view the ground is any material: the casing is what an outline is seen against.
        QVERIFY(v.casing.isValid() && v.casesHover);
        QVERIFY(contrast(v.accent, v.casing) >= 7.0);
        QCOMPARE(v.hoverAlpha, 1.0);
        QCOMPARE(v.top, v.bottom); // no gradient
    }

    void aCheckBoxIsSeenUnchecked_data() { everyTextCanBeRead_data(); }

    /// Wrong: in dark, what could be checked would be a shade of the window.
    void aCheckBoxIsSeenUnchecked()
    {
        QFETCH(int, scheme);
        QFETCH(bool, isSystemDark);
        use(scheme, isSystemDark);
        const QImage image = checkBox(QStyle::State_Enabled | QStyle::State_Off);
        for (int i = 8; i < 14; ++i) { // between the corners
            QVERIFY(contrast(image.pixelColor(i, 4), theme().window) >= 3.0 - 1e-9);
            QVERIFY(contrast(image.pixelColor(4, i), theme().window) >= 3.0 - 1e-9);
        }
    }

    void aDisabledCheckBoxIsFainter_data() { everyTextCanBeRead_data(); }

    /// Wrong: in high contrast what cannot be checked is the boldest box on the page.
    void aDisabledCheckBoxIsFainter()
    {
        QFETCH(int, scheme);
        QFETCH(bool, isSystemDark);
        use(scheme, isSystemDark);
        for (const QStyle::StateFlag checked : {QStyle::State_Off, QStyle::State_On}) {
            const QImage on = checkBox(QStyle::State_Enabled | checked), off = checkBox(checked);
            for (int i = 8; i < 14; ++i)
                for (const QPoint &at : {QPoint(i, 4), QPoint(4, i)}) {
                    const double faint = contrast(off.pixelColor(at), theme().window);
                    QVERIFY(faint < 0.8 * contrast(on.pixelColor(at), theme().window));
                    QVERIFY(faint > 1.15); // it is there
                }
        }
    }

    void aDialogThatSavesIsOfTheTheme_data() { everyTextCanBeRead_data(); }

    /// Wrong: in dark, the buttons and lists that it makes when it becomes one that saves are
    /// light.
    void aDialogThatSavesIsOfTheTheme()
    {
        QFETCH(int, scheme);
        QFETCH(bool, isSystemDark);
        use(scheme, isSystemDark);
        FileDialog dialog(nullptr, QStringLiteral("Save"), m_folder.path(),
                          QStringLiteral("Models (*.fff)"));
        dialog.setAcceptMode(QFileDialog::AcceptSave);
        dialog.show();
        const QList<QWidget *> parts = dialog.findChildren<QWidget *>();
        QVERIFY(parts.size() > 10);
        for (const QWidget *part : parts)
            for (const auto role : {QPalette::Button, QPalette::Base, QPalette::Highlight})
                QCOMPARE(part->palette().color(QPalette::Active, role),
                         theme().palette().color(QPalette::Active, role));
    }

    void headingsAreHeavier_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("heading");
        QTest::newRow("English") << "en"
                                 << "Checks";
        QTest::newRow("Japanese") << "ja" << QStringLiteral("チェック形状");
        QTest::newRow("Chinese") << "zh_CN" << QStringLiteral("检查轮廓");
    }

    /// Wrong: with a font of one weight, headings look as what stands below them.
    void headingsAreHeavier()
    {
        QFETCH(QString, language);
        QFETCH(QString, heading);
        const QLocale before;
        QLocale::setDefault(QLocale(language));
        const auto ink = [&heading](QFont::Weight weight) {
            QImage image(200, 40, QImage::Format_Grayscale8);
            image.fill(Qt::white);
            QPainter painter(&image);
            QFont font = painter.font();
            font.setPixelSize(20);
            font.setWeight(weight);
            painter.setFont(font);
            painter.drawText(10, 30, heading);
            int sum = 0;
            for (int i = 0; i < image.width() * image.height(); ++i)
                sum += 255 - qGray(image.pixel(i % image.width(), i / image.width()));
            return sum;
        };
        const int plain = ink(QFont::Normal), heavy = ink(headingWeight());
        QLocale::setDefault(before);
        QVERIFY2(heavy > 1.1 * plain, qPrintable(QStringLiteral("%1, %2").arg(plain).arg(heavy)));
    }

private:
    /// On the window's ground, 4 px from the edges.
    static QImage checkBox(QStyle::State state)
    {
        FieldStyle style;
        QStyleOptionButton option;
        option.rect = {4, 4, 14, 14};
        option.palette = theme().palette();
        if (!state.testFlag(QStyle::State_Enabled))
            option.palette.setCurrentColorGroup(QPalette::Disabled);
        option.state = state;
        QImage image(22, 22, QImage::Format_RGB32);
        image.fill(theme().window);
        QPainter painter(&image);
        style.drawPrimitive(QStyle::PE_IndicatorCheckBox, &option, &painter, nullptr);
        return image;
    }

    static void use(int scheme, bool isSystemDark)
    {
        const QPalette before = QApplication::palette();
        QApplication::setPalette(
            QPalette(isSystemDark ? QColor(0x30, 0x30, 0x30) : QColor(0xf0, 0xf0, 0xf0)));
        settings().setColourScheme(static_cast<ColourScheme>(scheme));
        QWidget window;
        applyTheme(&window);
        QApplication::setPalette(before);
    }

    QTemporaryDir m_folder;
};

FFF_TEST_WITH(TestTheme, fff::testing::runWithin<TestTheme, QApplication>)
#include "tst_theme.moc"
