// Work on another thread of which only the newest result counts: one runs, the newest request
// waits, the others are dropped. Every result says which revision it belongs to, so that a late one
// can be shown as older.
#pragma once

#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace fff {

/// Input is copied to the worker. `work` runs there, never twice at once, so that it may own
/// caches; `publish` runs on the thread that owns this object. The destructor waits for the one
/// that runs. What `work` throws is logged and not published: the result before it stays the last.
template <class Input, class Output>
class LatestJob
{
public:
    using Work = std::function<Output(const Input &)>;
    using Publish = std::function<void(std::uint64_t revision, Output output)>;

    LatestJob(Work work, Publish publish) : m_work(std::move(work)), m_publish(std::move(publish))
    {
    }
    LatestJob(const LatestJob &) = delete;
    LatestJob &operator=(const LatestJob &) = delete;

    bool isBusy() const { return m_isRunning; }

    void request(std::uint64_t revision, Input input)
    {
        m_waiting.emplace(revision, std::move(input));
        if (!m_isRunning)
            startWaiting();
    }

    /// Blocks until nothing runs or waits; publishes what becomes ready on the way.
    void finish()
    {
        while (m_isRunning) {
            {
                std::unique_lock lock(m_mutex);
                m_ready.wait(lock, [this] { return m_result.has_value(); });
            }
            collect();
        }
    }

private:
    using Tagged = std::pair<std::uint64_t, std::optional<Output>>;

    std::optional<Output> tryWork(const Input &input)
    {
        try {
            return m_work(input);
        } catch (const std::exception &exception) {
            qWarning("work in the background failed: %s", exception.what());
            return std::nullopt;
        }
    }

    void startWaiting()
    {
        m_isRunning = true;
        m_worker = std::jthread([this, request = std::move(*m_waiting)] {
            std::optional<Output> output = tryWork(request.second);
            {
                const std::lock_guard lock(m_mutex);
                m_result.emplace(request.first, std::move(output));
            }
            m_ready.notify_all();
            // Dropped by Qt when the receiver is gone by then.
            QMetaObject::invokeMethod(
                &m_receiver, [this] { collect(); }, Qt::QueuedConnection);
        });
        m_waiting.reset();
    }

    /// Also called late, for a result that finish() has taken already: then there is none.
    void collect()
    {
        std::optional<Tagged> result;
        {
            const std::lock_guard lock(m_mutex);
            result.swap(m_result);
        }
        if (!result)
            return;
        m_isRunning = false;
        if (m_waiting)
            startWaiting();
        if (result->second)
            m_publish(result->first, std::move(*result->second));
    }

    Work m_work;
    Publish m_publish;
    std::optional<std::pair<std::uint64_t, Input>> m_waiting; // owner's thread only
    bool m_isRunning = false;                                 // owner's thread only
    std::mutex m_mutex;
    std::condition_variable m_ready;
    std::optional<Tagged> m_result; // guarded by m_mutex; no output where the work failed
    QObject m_receiver;
    std::jthread m_worker; // last: its destructor waits before the rest goes
};

} // namespace fff
