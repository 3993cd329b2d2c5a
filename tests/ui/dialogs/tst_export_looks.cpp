// The Export panel in sight: nothing of it is cut off, in its least size and in a language whose
// words are longer, and every field says what it is to those who hear it.
#include <QTest>

#include "core/session/check_list.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "ui/base/translations.h"
#include "ui/dialogs/sheet_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QScrollArea>
#include <QTranslator>

using namespace fff;
using namespace fff::ui;

namespace {

/// Every text a third longer than in English, as German is.
class LongWords : public QTranslator
{
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *, const char *source, const char *, int) const override
    {
        const QString text = QString::fromUtf8(source);
        return text + QString(text.size() / 3, u'n');
    }
};

/// Words that have less room than they take; empty: all are whole.
QString cutOff(const QWidget &widget)
{
    const QFontMetrics metrics(widget.font());
    QString text;
    int needed = 0;
    if (const auto *label = qobject_cast<const QLabel *>(&widget)) {
        if (label->text().isEmpty())
            return {};
        text = label->text();
        needed = label->wordWrap() ? 0 : label->sizeHint().width();
        if (label->wordWrap() && label->heightForWidth(label->width()) > label->height())
            return text;
    } else if (const auto *button = qobject_cast<const QAbstractButton *>(&widget)) {
        text = button->text();
        needed = text.isEmpty() ? 0 : button->sizeHint().width();
    } else if (const auto *box = qobject_cast<const QComboBox *>(&widget)) {
        text = box->currentText();
        needed = metrics.horizontalAdvance(text) + 24; // the arrow
    } else if (const auto *field = qobject_cast<const QDoubleSpinBox *>(&widget)) {
        text = field->text();
        needed = metrics.horizontalAdvance(text) + 24;
    }
    return needed > widget.width() ? text : QString();
}

/// What reaches out of the area that scrolls it, at its sides.
bool isBesideItsArea(const QWidget &widget, const QScrollArea &area)
{
    const int left = widget.mapTo(area.widget(), QPoint()).x() + area.widget()->x();
    return left < 0 || left + widget.width() > area.viewport()->width();
}

/// The first thing that is not whole in sight; empty: all is.
QString firstFault(const QDialog &dialog)
{
    const auto *choices = dialog.findChild<QScrollArea *>(QStringLiteral("exportChoices"));
    for (const QWidget *widget : dialog.findChildren<QWidget *>()) {
        if (!widget->isVisible())
            continue;
        const QString name = QLatin1String(widget->metaObject()->className()) + u' ' +
                             widget->objectName() + QStringLiteral(": ");
        if (const QString cut = cutOff(*widget); !cut.isEmpty())
            return name + cut;
        if (choices->widget()->isAncestorOf(widget) && isBesideItsArea(*widget, *choices))
            return name + QStringLiteral("beside its area");
    }
    return {};
}

} // namespace

class TestExportLooks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void nothingIsCutOff_data();
    void nothingIsCutOff();
    void allIsGoodInOneLine();
    void everythingIsNamed();
    void allOfItIsReachedByTab();
    void thePreviewShrinksFirst();

private:
    void show(const std::function<void(QDialog *)> &act);

    std::unique_ptr<QTemporaryDir> m_folder;
    MainWindow *m_window = nullptr;
};

void TestExportLooks::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
}

void TestExportLooks::cleanup()
{
    closeEverything();
}

/// With a problem, several sheets and all rows open.
void TestExportLooks::show(const std::function<void(QDialog *)> &act)
{
    m_window = openWindow();
    m_window->show();
    Document document = squareDocument(320);
    for (const double at : {100.0, 200.0})
        document = test::withSection(document, test::plateOf(0, 0, 320, 320), test::front(at));
    m_window->bench().session().commit(QStringLiteral("draw"), document);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        auto *sheet = dialog->findChild<QComboBox *>(QStringLiteral("exportSheet"));
        sheet->setCurrentIndex(sheet->count() - 1);
        Q_EMIT sheet->activated(sheet->count() - 1);
        typeInto(dialog, "exportMargin", QStringLiteral("80")); // too large for the sheet
        QTest::qWait(0);
        QTRY_VERIFY(dialog->findChild<QWidget *>(QStringLiteral("remark1")));
        act(dialog);
    });
}

void TestExportLooks::nothingIsCutOff_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("hasLongWords");
    for (const QSize size : {QSize(860, 560), QSize(1048, 700), QSize(1300, 800)})
        for (const bool isLong : {false, true})
            QTest::newRow(qPrintable(QStringLiteral("%1 × %2%3")
                                         .arg(size.width())
                                         .arg(size.height())
                                         .arg(isLong ? QStringLiteral(", long words") : QString())))
                << size << isLong;
}

void TestExportLooks::nothingIsCutOff()
{
    QFETCH(QSize, size);
    QFETCH(bool, hasLongWords);
    LongWords words;
    if (hasLongWords)
        QCoreApplication::installTranslator(&words);
    show([&](QDialog *dialog) {
        dialog->resize(size);
        awaitSheets(dialog);
        // Longer words may make it wider, as far as the least window.
        QVERIFY2(dialog->width() <= std::max(size.width(), 1000),
                 qPrintable(QString::number(dialog->width())));
        // Checks come in and are laid out meanwhile.
        QTRY_COMPARE(firstFault(*dialog), QString());
    });
    QCoreApplication::removeTranslator(&words);
}

// Wrong: a green check with nothing beside it.
void TestExportLooks::allIsGoodInOneLine()
{
    m_window = openWindow();
    m_window->show();
    QVERIFY(
        m_window->files().openFile(QStringLiteral(FFF_SOURCES "/resources/samples/dinosaur.fff")));
    const auto *checks = m_window->findChild<CheckList *>();
    QTRY_VERIFY_WITH_TIMEOUT(!checks->all().empty() && checks->age() == CheckList::Age::Current,
                             30000);
    inExportPanel(*m_window, [&](QDialog *dialog) {
        const QString good = QStringLiteral("Stands \u00B7 Connected \u00B7 Can be assembled");
        auto *area = dialog->findChild<QWidget *>(QStringLiteral("exportRemarks"));
        const auto line = [area]() -> QLabel * {
            const auto labels = area->findChildren<QLabel *>(QStringLiteral("remarkText"));
            return labels.isEmpty() ? nullptr : labels.last();
        };
        QTRY_VERIFY_WITH_TIMEOUT(line() && line()->text().startsWith(good), 30000);
        QTest::qWait(50); // what was changed is laid out
        QVERIFY(line()->isVisible());
        QVERIFY(line()->width() >= QFontMetrics(line()->font()).horizontalAdvance(good));
        const QRect place(line()->mapTo(area, QPoint()), line()->size());
        QVERIFY(area->rect().contains(place));
        int inked = 0; // it can be read there
        const QImage seen = area->grab(place).toImage();
        for (int i = 0; i < seen.width() * seen.height(); ++i)
            inked += seen.pixelColor(i % seen.width(), i / seen.width()) != seen.pixelColor(0, 0);
        QVERIFY(inked > 0);
    });
}

void TestExportLooks::everythingIsNamed()
{
    show([](QDialog *dialog) {
        for (const QWidget *widget : dialog->findChildren<QWidget *>()) {
            const bool isReached = widget->isVisible() && (widget->focusPolicy() & Qt::TabFocus) &&
                                   widget->isEnabled();
            const auto *button = qobject_cast<const QAbstractButton *>(widget);
            if (!isReached || widget->focusProxy())
                continue;
            QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                     qPrintable(QLatin1String(widget->metaObject()->className()) + u' ' +
                                widget->objectName()));
        }
    });
}

// Wrong: who has no mouse cannot say which sheet.
void TestExportLooks::allOfItIsReachedByTab()
{
    show([](QDialog *dialog) {
        QSet<QString> reached;
        exportButton(dialog)->setFocus();
        for (int i = 0; i < 80; ++i) {
            QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
            for (const QWidget *at = dialog->focusWidget(); at && at != dialog;
                 at = at->parentWidget())
                reached += at->objectName();
        }
        for (const char *name :
             {"exportMeasure",     "exportThickness", "exportSheet",      "exportSheetWidth",
              "exportSheetHeight", "exportUse",       "exportFile",       "exportChangePlace",
              "exportKerf",        "exportClearance", "exportSpacing",    "exportMargin",
              "exportRotation",    "exportReference", "exportFittedSlit", "exportBridges",
              "exportBridgeWidth", "exportLead",      "exportSharedCuts", "exportMachine",
              "exportTabs",        "exportNextSheet", "sheetView",        "exportRemarks",
              "exportOpensFolder", "exportCancel",    "exportNow"})
            QVERIFY2(reached.contains(QLatin1String(name)), name);
    });
}

void TestExportLooks::thePreviewShrinksFirst()
{
    show([](QDialog *dialog) {
        const auto widthOf = [dialog](const char *name) {
            return dialog->findChild<QWidget *>(QLatin1String(name))->width();
        };
        dialog->resize(1048, 700);
        QTest::qWait(0);
        const int choices = widthOf("exportChoices"), view = widthOf("sheetView");
        dialog->resize(860, 560);
        QTest::qWait(0);
        QCOMPARE(widthOf("exportChoices"), choices);
        QCOMPARE(widthOf("sheetView"), view - (1048 - 860));
    });
}

FFF_TEST_WITH(TestExportLooks, [](int argc, char *argv[]) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    installTranslations(application);
    TestExportLooks test;
    return QTest::qExec(&test, argc, argv);
})
#include "tst_export_looks.moc"
