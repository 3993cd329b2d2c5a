// What is told under the tool bar, and what is offered there until somebody answers.
#include <QTest>

#include "tests/test_program.h"
#include "ui/base/message_bar.h"

#include <QApplication>
#include <QPushButton>
#include <QToolButton>

#include <memory>

using namespace fff::ui;

class TestMessageBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }

    void anOfferStaysWhenSomethingElseIsOver();
    void anOfferComesBackAfterWhatWasToldMeanwhile();
    void anAnsweredOfferIsGone();
    void whatIsToldIsOverWithIt();

private:
    void offer(const QString &text)
    {
        m_bar->showNext(MessageBar::Severity::Info, {text},
                        {{QStringLiteral("Take it"), [this] { ++m_taken; }}});
    }
    void tell(const QString &text) { m_bar->show(MessageBar::Severity::Warning, {text}); }
    void close()
    {
        QTest::mouseClick(m_bar->findChild<QToolButton *>(QStringLiteral("closeMessage")),
                          Qt::LeftButton);
    }
    void take()
    {
        for (auto *verb : m_bar->findChildren<QPushButton *>(QStringLiteral("messageVerb")))
            if (verb->isVisible())
                return QTest::mouseClick(verb, Qt::LeftButton);
        QFAIL("nothing is offered");
    }
    QString shown() const { return m_bar->isVisible() ? m_bar->text() : QString(); }

    std::unique_ptr<QWidget> m_window;
    MessageBar *m_bar = nullptr;
    int m_taken = 0;
};

void TestMessageBar::init()
{
    m_taken = 0;
    m_window = std::make_unique<QWidget>();
    m_window->resize(700, 200);
    m_bar = new MessageBar(m_window.get());
    m_bar->resize(700, 60);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

// Wrong: recovered work is not offered any more because a picture was read.
void TestMessageBar::anOfferStaysWhenSomethingElseIsOver()
{
    offer(QStringLiteral("Recovered"));
    m_bar->dismiss();
    m_bar->show(MessageBar::Severity::Warning, {}); // no warnings: nothing to tell
    QCOMPARE(shown(), QStringLiteral("Recovered"));
    take();
    QCOMPARE(m_taken, 1);
}

void TestMessageBar::anOfferComesBackAfterWhatWasToldMeanwhile()
{
    offer(QStringLiteral("Recovered"));
    offer(QStringLiteral("Another"));
    for (int again = 0; again < 2; ++again) {
        tell(QStringLiteral("Mended"));
        QCOMPARE(shown(), QStringLiteral("Mended"));
        close();
        QCOMPARE(shown(), QStringLiteral("Recovered"));
    }
    tell(QStringLiteral("Mended"));
    m_bar->dismiss();
    QCOMPARE(shown(), QStringLiteral("Recovered"));
    close();
    QCOMPARE(shown(), QStringLiteral("Another"));
    take();
    QCOMPARE(shown(), QString());
    QCOMPARE(m_taken, 1);
}

void TestMessageBar::anAnsweredOfferIsGone()
{
    offer(QStringLiteral("Recovered"));
    take();
    QCOMPARE(shown(), QString());
    tell(QStringLiteral("Mended"));
    close();
    QCOMPARE(shown(), QString());
}

void TestMessageBar::whatIsToldIsOverWithIt()
{
    tell(QStringLiteral("Mended"));
    tell(QStringLiteral("Broken"));
    QCOMPARE(shown(), QStringLiteral("Broken"));
    m_bar->dismiss();
    QCOMPARE(shown(), QString());
}

FFF_TEST_WITH(TestMessageBar, fff::testing::runWithin<TestMessageBar, QApplication>)
#include "tst_message_bar.moc"
