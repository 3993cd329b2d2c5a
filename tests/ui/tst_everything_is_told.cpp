// Every page, bar and dialog, for who does not see it: all that takes the focus or is clicked has a
// name for screen readers.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/every_page.h"
#include "ui/base/theme.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QTabBar>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

constexpr QSize kUsualSize(1440, 900);

QString whereIs(const QWidget &widget)
{
    QStringList names{QLatin1String(widget.metaObject()->className())};
    for (const QWidget *of = &widget; of && names.size() < 4; of = of->parentWidget())
        if (!of->objectName().isEmpty())
            names += of->objectName();
    return names.join(QStringLiteral(" in "));
}

/// Parts that Qt makes within a widget of its own are told of as that one.
bool isPartOfAnother(const QWidget &widget)
{
    if (widget.focusProxy() || widget.objectName().startsWith(QStringLiteral("qt_")))
        return true;
    const QWidget *parent = widget.parentWidget();
    return qobject_cast<const QAbstractSpinBox *>(parent) ||
           qobject_cast<const QLineEdit *>(parent) || qobject_cast<const QComboBox *>(parent) ||
           (qobject_cast<const QAbstractScrollArea *>(parent) &&
            static_cast<const QAbstractScrollArea *>(parent)->viewport() == &widget);
}

/// What has to have a name and has none.
QStringList unnamed(const QWidget &top)
{
    QStringList found;
    for (QWidget *widget : top.findChildren<QWidget *>()) {
        const bool isUsed =
            widget->focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton *>(widget);
        const auto *tabs = qobject_cast<const QTabBar *>(widget);
        if (!isUsed || (tabs && tabs->count() == 0) || !widget->isVisible() ||
            widget->window() != top.window() || isPartOfAnother(*widget))
            continue;
        const QAccessibleInterface *told = QAccessible::queryAccessibleInterface(widget);
        if (!told || told->text(QAccessible::Name).trimmed().isEmpty())
            found += QStringLiteral("%1 has no name").arg(whereIs(*widget));
    }
    return found;
}

/// Cells that are only a sign.
QStringList unnamedCells(const QWidget &top)
{
    QStringList found;
    for (const QAbstractItemView *view : top.findChildren<QAbstractItemView *>()) {
        if (!view->isVisible() || view->window() != top.window())
            continue;
        const QAbstractItemModel *model = view->model();
        for (int row = 0; model && row < std::min(20, model->rowCount(view->rootIndex())); ++row)
            for (int column = 0; column < model->columnCount(view->rootIndex()); ++column) {
                const QModelIndex cell = model->index(row, column, view->rootIndex());
                const bool isSeen = !view->visualRect(cell).isEmpty() &&
                                    !cell.data(Qt::DecorationRole).value<QIcon>().isNull();
                if (isSeen && cell.data(Qt::DisplayRole).toString().isEmpty() &&
                    cell.data(Qt::AccessibleTextRole).toString().isEmpty())
                    found += QStringLiteral("column %1 of %2 has no words")
                                 .arg(column)
                                 .arg(whereIs(*view));
            }
    }
    return found;
}

} // namespace

class TestEverythingIsTold : public QObject, private EveryPage
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_found.clear(); }
    void cleanup() { closeAll(); }

    /// Wrong: a screen reader says "button".
    void itHasAName_data();
    void itHasAName();

private:
    using EveryPage::look;
    void look(const QString &state, QWidget &top) override;
    void tell();

    std::function<QStringList(QWidget &)> m_wrong;
    std::map<QString, QString> m_found; // what is wrong, and where it was seen first
};

void TestEverythingIsTold::look(const QString &state, QWidget &top)
{
    unfold(top);
    QTest::qWait(30);
    for (const QString &wrong : m_wrong(top))
        m_found.emplace(wrong, state);
}

void TestEverythingIsTold::tell()
{
    for (const auto &[wrong, state] : m_found)
        qWarning("%s: %s", qPrintable(state), qPrintable(wrong));
    QVERIFY2(m_found.empty(), qPrintable(QStringLiteral("%1 are wrong").arg(m_found.size())));
}

void TestEverythingIsTold::itHasAName_data()
{
    QTest::addColumn<QString>("language");
    for (const char *language : {"en", "ja"})
        QTest::newRow(language) << QString::fromLatin1(language);
}

void TestEverythingIsTold::itHasAName()
{
    QFETCH(QString, language);
    m_wrong = [](QWidget &top) { return unnamed(top) + unnamedCells(top); };
    openWith(language, kUsualSize);
    showPages();
    showOperations();
    showDialogs();
    tell();
}

FFF_TEST_WITH(TestEverythingIsTold, runOnLargeScreen<TestEverythingIsTold>)
#include "tst_everything_is_told.moc"
