// A process that is stopped whenever it asks the system for something, to be killed there or to be
// told that it cannot be done.
#pragma once

#include <cerrno>
#include <csignal>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fff::test {

/// Of what touches files. Between two of these calls nothing on the disk changes, so that being
/// stopped at any other one is being stopped at the next of these.
inline bool touchesFiles(long call)
{
    static const std::set<long> calls = {
#ifdef SYS_open
        SYS_open,     SYS_creat,     SYS_mkdir,     SYS_rename,
        SYS_link,     SYS_unlink,    SYS_rmdir,     SYS_chmod,
#endif
        SYS_openat,   SYS_mkdirat,   SYS_renameat2, SYS_linkat,
        SYS_unlinkat, SYS_fchmod,    SYS_fchmodat,
#ifdef SYS_renameat
        SYS_renameat,
#endif
        SYS_write,    SYS_pwrite64,  SYS_writev,    SYS_ftruncate,
        SYS_fsync,    SYS_fdatasync, SYS_flock,     SYS_close,
    };
    return calls.contains(call);
}

class TracedChild
{
public:
    struct Call
    {
        long number;
        long first; // argument
    };

    /// Runs there what ends with an exit status; its threads are followed.
    explicit TracedChild(const std::function<int()> &body)
    {
        m_pid = fork();
        if (m_pid == 0) {
            if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
                _exit(kRefused);
            raise(SIGSTOP);
            _exit(body());
        }
        int status = 0;
        waitpid(m_pid, &status, 0);
        m_hasEnded = !WIFSTOPPED(status);
        m_wasRefused = m_hasEnded;
        ptrace(PTRACE_SETOPTIONS, m_pid, nullptr,
               PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_EXITKILL);
        m_stopped = m_pid;
    }
    ~TracedChild()
    {
        kill();
        reap();
    }
    TracedChild(const TracedChild &) = delete;
    TracedChild &operator=(const TracedChild &) = delete;

    /// Where no process may look at another one.
    bool wasRefused() const { return m_wasRefused; }
    /// 0 after an end of its own that went well.
    int status() const { return m_status; }

    /// On to the next call of any thread, before it is made. None: it has ended.
    std::optional<Call> next()
    {
        while (!m_hasEnded) {
            goOn();
            int status = 0;
            const pid_t thread = waitpid(-1, &status, __WALL);
            if (thread < 0) {
                m_hasEnded = true;
                break;
            }
            if (WIFEXITED(status) || WIFSIGNALED(status)) {
                m_stopped = 0;
                if (thread == m_pid) {
                    m_hasEnded = true;
                    m_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
                }
                continue;
            }
            m_stopped = thread;
            m_signal = 0;
            if (WSTOPSIG(status) == (SIGTRAP | 0x80)) {
                if (const std::optional<Call> call = entered(thread))
                    return call;
            } else if (status >> 8 != (SIGTRAP | (PTRACE_EVENT_CLONE << 8)) &&
                       WSTOPSIG(status) != SIGSTOP) {
                m_signal = WSTOPSIG(status);
            }
        }
        return std::nullopt;
    }

    /// The call that it stands before is not made and ends with this error.
    void refuse(int number)
    {
        m_errors[m_stopped] = number;
        setRegister(m_stopped, &user_regs_struct::orig_rax, -1);
    }

    /// Its parent has not been told yet: it is a zombie.
    void kill()
    {
        if (!m_hasEnded && m_pid > 0)
            ::kill(m_pid, SIGKILL);
        // It is gone when its threads have been taken note of, one by one.
        siginfo_t info = {};
        while (!m_hasEnded && waitid(P_ALL, 0, &info, WEXITED | WNOWAIT | __WALL) == 0 &&
               info.si_pid != m_pid)
            waitpid(info.si_pid, nullptr, __WALL);
    }
    void reap()
    {
        int status = 0;
        while (waitpid(-1, &status, __WALL) > 0) {
        }
        m_hasEnded = true;
    }

private:
    static constexpr int kRefused = 99;

    void goOn()
    {
        if (m_stopped > 0)
            ptrace(PTRACE_SYSCALL, m_stopped, nullptr, m_signal);
        m_stopped = 0;
    }

    std::optional<Call> entered(pid_t thread)
    {
        __ptrace_syscall_info info = {};
        ptrace(PTRACE_GET_SYSCALL_INFO, thread, sizeof info, &info);
        if (info.op == PTRACE_SYSCALL_INFO_ENTRY)
            return Call{static_cast<long>(info.entry.nr), static_cast<long>(info.entry.args[0])};
        if (const auto error = m_errors.find(thread); error != m_errors.end()) {
            setRegister(thread, &user_regs_struct::rax, -error->second);
            m_errors.erase(error);
        }
        return std::nullopt;
    }

    static void setRegister(pid_t thread, unsigned long long user_regs_struct::*which, int value)
    {
        user_regs_struct registers = {};
        ptrace(PTRACE_GETREGS, thread, nullptr, &registers);
        registers.*which = static_cast<unsigned long long>(static_cast<long long>(value));
        ptrace(PTRACE_SETREGS, thread, nullptr, &registers);
    }

    pid_t m_pid = 0;
    pid_t m_stopped = 0; // thread that waits to be let go on
    int m_signal = 0;    // that it gets then
    int m_status = -1;
    bool m_hasEnded = false, m_wasRefused = false;
    std::map<pid_t, int> m_errors; // of threads in a call that was not made
};

} // namespace fff::test
