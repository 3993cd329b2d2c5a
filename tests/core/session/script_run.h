// Scripts of a person's hand (tests/data/strokes), played in a session of their own.
#pragma once

#include "core/session/replay.h"
#include "core/session/session_host.h"

#include <QFile>

#include <cmath>
#include <vector>

namespace fff::test {

/// The text of a script, by its name without the ending.
inline Result<QByteArray> scriptNamed(const QString &name)
{
    QFile file(QStringLiteral(FFF_TEST_DATA "/strokes/") + name + QStringLiteral(".json"));
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::CannotOpen, name.toStdString(), {"no such script"});
    return file.readAll();
}

class ScriptRun
{
public:
    ScriptRun() : host(session), interaction(host) {}

    Result<void> play(const QByteArray &script) { return replay(script, session, interaction); }
    Result<void> playFile(const QString &name)
    {
        const Result<QByteArray> script = scriptNamed(name);
        return script ? play(*script) : tl::unexpected(script.error());
    }
    const std::vector<SectionPointer> &sections() const
    {
        return session.committed().document.sections;
    }

    Session session;
    SessionHost host;
    Interaction interaction;
};

/// The section's plane holds its slit, which is in this parent, and stands on it at a right angle.
inline bool standsOnItsSlit(const Section &parent, const Section &section)
{
    if (!section.parent || !(section.parent->section == SectionRef(parent.id)))
        return false;
    const Vec3 from = parent.frame.toWorld(section.parent->slitFrom);
    const Vec3 to = parent.frame.toWorld(section.parent->slitTo);
    return std::abs(section.frame.height(from)) < 1e-9 &&
           std::abs(section.frame.height(to)) < 1e-9 &&
           std::abs(section.frame.normal().dot(parent.frame.normal())) < 1e-9 &&
           std::abs(section.frame.x.dot(section.frame.y)) < 1e-9 && (to - from).norm() > 1.0;
}

} // namespace fff::test
