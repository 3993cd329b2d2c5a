// Work that may take long, without a window that hangs: it runs on another thread, and when half a
// second has gone by, a small dialog says what is being done and offers to give it up.
#pragma once

#include <QString>
#include <QThreadPool>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>

class QWidget;

namespace fff::ui {

enum class MayCancel { No, Yes };

/// How far work is, 0 … 1, told by another thread; below 0 where that is not known.
using WorkShare = std::shared_ptr<std::atomic<double>>;

/// Waits until `isDone`, which is asked now and then. No input reaches any window meanwhile but the
/// dialog's, which shows how far it is where that is known. False when it was given up.
bool waitWithProgress(QWidget &window, const QString &text, MayCancel mayCancel,
                      const std::function<bool()> &isDone, const WorkShare &share = {});

/// Work that only this thread can do, in pieces of some tenths of a second at most.
enum class Pieces { Done, Failed, GivenUp };
/// Does `doPiece` for 0 … count − 1, until one says false. No input reaches any window meanwhile
/// but that of the dialog, which shows how far it is.
Pieces doInPieces(QWidget &window, const QString &text, int count,
                  const std::function<bool(int piece)> &doPiece);

/// The result of `work`, which owns all that it reads; nothing when it was given up: it then runs
/// on to its end and what it made is dropped.
template <class Output>
std::optional<Output> inBackground(QWidget &window, const QString &text, MayCancel mayCancel,
                                   std::function<Output()> work, const WorkShare &share = {})
{
    auto task = std::make_shared<std::packaged_task<Output()>>(std::move(work));
    std::future<Output> result = task->get_future();
    QThreadPool::globalInstance()->start([task] { (*task)(); });
    const auto isReady = [&result](std::chrono::milliseconds time) {
        return result.wait_for(time) == std::future_status::ready;
    };
    using namespace std::chrono_literals;
    // Most work is over before anyone sees; then no event loop runs at all.
    if (!isReady(100ms) && !waitWithProgress(
                               window, text, mayCancel, [&] { return isReady(0ms); }, share))
        return std::nullopt;
    return result.get();
}

} // namespace fff::ui
