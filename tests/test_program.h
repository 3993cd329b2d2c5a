// A test program holds the test classes of a room; each is a test of its own to ctest:
//     tests_geometry tst_boolean [options of Qt Test]
// runs the one from tst_boolean.cpp. Include it last but for the moc file.
#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QTest>

namespace fff::testing {

using Run = int (*)(int argc, char *argv[]);

/// Before main: what the program runs for the file's name.
class Registered
{
public:
    Registered(const char *file, Run run);
};

/// The class within an application of this kind.
template <class Test, class Application = QCoreApplication>
int runWithin(int argc, char *argv[])
{
    Application application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace fff::testing

/// The class of this file, run by a function.
#define FFF_TEST_WITH(Class, ...)                                                                  \
    static const fff::testing::Registered registered##Class(__FILE__, __VA_ARGS__);
/// The same within a QCoreApplication.
#define FFF_TEST(Class) FFF_TEST_WITH(Class, fff::testing::runWithin<Class>)

/// For a test that finds no real models: a fault where ../shared is beside this tree, else said.
#define FFF_WITHOUT_SHARED()                                                                       \
    do {                                                                                           \
        QVERIFY2(!QDir(QStringLiteral(FFF_SHARED)).exists(), "they are not in " FFF_SHARED);       \
        QSKIP("there is no " FFF_SHARED ", so nothing real was tested");                           \
    } while (false)
