// Any bytes as a script of what a person does, read and run. If this stops, some series of presses,
// moves and commands takes the window down, or makes a model that cannot be saved.
#include "core/model/edits.h"
#include "core/session/replay.h"
#include "core/session/session_host.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/properties.h"

#include <QCoreApplication>

using namespace fff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static int argc = 1;
    static char name[] = "fuzz_replay", *argv[] = {name, nullptr};
    static QCoreApplication application(argc, argv);

    Session session;
    session.reset(newDocument());
    SessionHost host(session);
    Interaction interaction(host);
    const auto bytes =
        QByteArray::fromRawData(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    if (const Result<void> played = replay(bytes, session, interaction); !played)
        fuzz::requireClear(played.error());
    fuzz::requireRoundTrip(session.committed().document);
    // Whatever was drawn can be undone, all of it.
    session.history()->setIndex(0);
    fuzz::requireRoundTrip(session.committed().document);
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size,
                                               std::size_t maxSize, unsigned int seed)
{
    return fuzz::mutateJson(data, size, maxSize, seed);
}
