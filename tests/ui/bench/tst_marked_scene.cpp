// What the hand does to sections in the view, and what is said beside the cursor.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/bench/marked_scene.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"

#include <QApplication>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestMarkedScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Wrong: the name that stands in Properties lies over the section that is worked on, too.
    void theChosenSectionIsNotNamedAgain()
    {
        QTemporaryDir folder;
        Settings::setFile(folder.filePath(QStringLiteral("settings.ini")));
        Workbench bench;
        bench.setViewport({900, 700});
        bench.session().commit(
            QStringLiteral("Draw"),
            withSection(withSection(newDocument(), plateOf(-50, 0, 50, 60), front()),
                        plateOf(-50, 0, 50, 60), front(-40)));
        bench.showAll("front");
        const Model &model = bench.session().model();
        const QString name = QString::fromStdString(model.section(0)->name);
        QCOMPARE(nameUnderCursor(bench), QString());
        PointerEvent move;
        const Vec2 at = bench.interaction().camera().toScreen({0.0, 30.0, 0.0}, {900, 700});
        move.position = at;
        bench.handle(move);
        QCOMPARE(nameUnderCursor(bench), name);
        bench.select({model.ref(0)});
        bench.handle(move);
        QCOMPARE(nameUnderCursor(bench), QString());
        bench.select({model.ref(0), model.ref(1)}); // Properties names neither
        bench.handle(move);
        QCOMPARE(nameUnderCursor(bench), name);
        bench.select({model.ref(1)});
        bench.handle(move);
        QCOMPARE(nameUnderCursor(bench), name);
    }
};

FFF_TEST_WITH(TestMarkedScene, fff::testing::runWithin<TestMarkedScene, QApplication>)
#include "tst_marked_scene.moc"
