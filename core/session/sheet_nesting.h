// How parts lie on their sheets, for those who show or write it: quickly after each edit, better
// when a person asks for it, for as long as somebody looks.
#pragma once

#include "core/analysis/nested.h"

#include <QElapsedTimer>
#include <QObject>

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string_view>

namespace fff {

class Session;

class SheetNesting : public QObject
{
    Q_OBJECT
public:
    /// The session outlives it.
    explicit SheetNesting(Session &session, QObject *parent = nullptr);

    /// Is worked out as long as anybody wants it. `who` takes it back before it goes.
    void setWanted(const void *who, bool isWanted);
    bool isWanted() const { return !m_wanting.empty(); }

    /// What is asked of the layout. Its work and its pinned parts are not looked at.
    void setOptions(const NestOptions &options);
    const NestOptions &options() const { return m_options; }

    /// A person asks for it. Quick lays all anew, in place of what edits have left; an edit during
    /// the others is laid quickly first, and they begin again; after one that comes later the level
    /// is Quick again.
    void nest(NestLevel level);
    NestLevel level() const { return m_level; }
    /// Ends a search; what is best so far stays.
    void stop();
    /// Good or Best goes on, or will when Quick is done.
    bool isSearching() const { return m_isSearching; }
    /// 0 … 1 of Good; below 0 where nothing is known.
    double progress() const;
    /// Since when a search goes on, seconds.
    double searchedFor() const;

    /// The newest that somebody asked for; null until there is one. Stays while something newer is
    /// worked out, and when nobody wants it any more.
    const std::shared_ptr<const Nested> &result() const { return m_result; }
    /// It is of the model and the options that are there.
    bool isCurrent() const;
    /// The same of this analysis: how its parts lie, or null.
    std::shared_ptr<const Layout> layoutOf(const AnalysisPointer &analysis,
                                           const NestOptions &options) const;

Q_SIGNALS:
    void changed();
    void progressed();

private:
    SheetsQuestion question(NestLevel level) const;
    void ask(NestLevel level);
    void follow();
    void take(std::string_view stage);
    void goOn();

    Session &m_session;
    std::set<const void *> m_wanting;
    NestOptions m_options;
    NestLevel m_level = NestLevel::Quick;   // that a person has asked for
    NestLevel m_running = NestLevel::Quick; // that the stage is asked for
    bool m_isSearching = false;
    QElapsedTimer m_since; // that somebody asked for it
    int m_round = 0, m_times = 0;
    std::shared_ptr<const SheetsQuestion> m_asked;
    std::shared_ptr<const Nested> m_result;
};

} // namespace fff
