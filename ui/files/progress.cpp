#include "ui/files/progress.h"

#include "ui/base/theme.h"

#include <QCloseEvent>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QProgressBar>
#include <QProgressDialog>
#include <QTimer>

namespace fff::ui {

namespace {

constexpr int kPatience = 500; // ms without a word
constexpr int kAskEvery = 10;  // ms
constexpr int kSteps = 1000;   // of a bar

/// A dialog that neither Esc nor its frame takes away before the work is done: it is what keeps
/// input from the windows.
class Progress : public QProgressDialog
{
public:
    Progress(const QString &text, MayCancel mayCancel, QWidget *window)
        : QProgressDialog(text, QString(), 0, 0, window, Qt::Dialog | Qt::CustomizeWindowHint),
          m_mayCancel(mayCancel)
    {
        setObjectName(QStringLiteral("progress"));
        setPalette(theme().palette());
        setWindowModality(Qt::ApplicationModal);
        setAutoClose(false);
        setAutoReset(false);
        setMinimumDuration(0);
        if (mayCancel == MayCancel::Yes)
            setCancelButtonText(QProgressDialog::tr("Cancel"));
    }

    void reject() override
    {
        if (m_mayCancel == MayCancel::Yes)
            Q_EMIT canceled(); // Esc comes here while the dialog is not the active window yet
    }

protected:
    void closeEvent(QCloseEvent *event) override
    {
        if (m_mayCancel == MayCancel::Yes)
            QProgressDialog::closeEvent(event);
        else
            event->ignore();
    }

private:
    MayCancel m_mayCancel;
};

} // namespace

bool waitWithProgress(QWidget &window, const QString &text, MayCancel mayCancel,
                      const std::function<bool()> &isDone, const WorkShare &share)
{
    QElapsedTimer since;
    since.start();
    QEventLoop loop;
    QTimer timer;
    timer.setInterval(kAskEvery);
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        if (isDone() || since.elapsed() > kPatience)
            loop.quit();
    });
    timer.start();
    if (!isDone())
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    if (isDone())
        return true;

    Progress dialog(text, mayCancel, &window);
    bool isGivenUp = false;
    if (mayCancel == MayCancel::Yes) {
        QObject::connect(&dialog, &QProgressDialog::canceled, &loop, [&] {
            isGivenUp = true;
            loop.quit();
        });
    }
    auto *bar = new QProgressBar(&dialog);
    bar->setRange(0, 0);
    dialog.setBar(bar);
    timer.disconnect();
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        if (isDone())
            loop.quit();
        if (const double done = share ? share->load() : -1.0; done >= 0.0) {
            bar->setRange(0, kSteps);
            bar->setValue(static_cast<int>(kSteps * done));
        }
    });
    dialog.show();
    loop.exec();
    return !isGivenUp;
}

Pieces doInPieces(QWidget &window, const QString &text, int count,
                  const std::function<bool(int piece)> &doPiece)
{
    QElapsedTimer since;
    since.start();
    QEventLoop loop;
    int done = 0;
    bool isFailed = false, isGivenUp = false;
    const auto next = [&] {
        if (done < count && !isFailed && !isGivenUp) {
            isFailed = !doPiece(done);
            ++done;
        }
        return done < count && !isFailed && !isGivenUp;
    };
    QTimer timer; // between two pieces all else that waits gets its turn
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        if (!next() || since.elapsed() > kPatience)
            loop.quit();
    });
    timer.start(0);
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    if (done < count && !isFailed) {
        Progress dialog(text, MayCancel::Yes, &window);
        // The dialog's own setValue() lets events in, and the next piece with them.
        auto *bar = new QProgressBar(&dialog);
        bar->setRange(0, count);
        bar->setValue(done);
        dialog.setBar(bar);
        QObject::connect(&dialog, &QProgressDialog::canceled, &loop, [&] {
            isGivenUp = true;
            loop.quit();
        });
        timer.disconnect();
        QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
            const bool goesOn = next();
            bar->setValue(done);
            if (!goesOn)
                loop.quit();
        });
        dialog.show();
        loop.exec();
    }
    return isGivenUp ? Pieces::GivenUp : isFailed ? Pieces::Failed : Pieces::Done;
}

} // namespace fff::ui
