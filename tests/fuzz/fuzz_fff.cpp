// Any bytes as a `.fff`. If this stops, a file from the net or a broken disk takes the window down,
// or a model that opens cannot be saved.
#include "core/io/error_text.h"
#include "core/io/fff_file.h"
#include "tests/fuzz/archive_mutator.h"
#include "tests/fuzz/properties.h"

using namespace fff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    const Result<io::LoadedDocument> loaded = io::readFffFile(bytes, "input.fff");
    if (!loaded) {
        fuzz::requireClear(loaded.error());
        return 0;
    }
    for (const Warning &warning : loaded->warnings)
        fuzz::require(!io::warningText(warning).isEmpty(), "a warning has words");
    fuzz::requireRoundTrip(loaded->document);
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size,
                                               std::size_t maxSize, unsigned int seed)
{
    return fuzz::mutateFff(data, size, maxSize, seed);
}
