#include "core/model/load_edits.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fff {

namespace {

tl::unexpected<Error> unknown(std::int64_t id)
{
    return failure(ErrorCode::UnknownReference, std::to_string(id), {std::to_string(id)});
}

tl::unexpected<Error> bad(const char *place)
{
    return failure(ErrorCode::BadValue, place);
}

Result<void> checked(const Document &document, const Load &load)
{
    const auto isIn = [](double value, double least, double most) {
        return std::isfinite(value) && value >= least && value <= most;
    };
    if (load.section.drawn.isValid() && !document.find(load.section.drawn))
        return unknown(load.section.drawn.value);
    if (!load.position.allFinite())
        return bad("position");
    if (!isIn(load.width, kLeastSpread, kMostSpread))
        return bad("width");
    if (load.isPush()) {
        if (!load.push.allFinite() || load.push.isZero(0.0) || !(load.push.norm() <= kMaxPush))
            return bad("push");
        return load.spread == Spread::Hanging ? Result<void>(bad("spread")) : Result<void>();
    }
    if (!(load.mass > 0.0 && isIn(load.mass, 0.0, kMaxWeight)))
        return bad("mass");
    if (!isIn(load.filled, 0.0, load.mass))
        return bad("filled");
    if (!isIn(load.height, 0.0, kMostSpread))
        return bad("height");
    return {};
}

} // namespace

Result<Document> addLoad(Document document, Load load)
{
    if (Result<void> sound = checked(document, load); !sound)
        return tl::unexpected(std::move(sound.error()));
    load.id = LoadId{document.nextId++};
    document.loads.push_back(std::move(load));
    return document;
}

Result<Document> setLoad(Document document, const Load &load)
{
    if (Result<void> sound = checked(document, load); !sound)
        return tl::unexpected(std::move(sound.error()));
    const auto found = std::find_if(document.loads.begin(), document.loads.end(),
                                    [&](const Load &one) { return one.id == load.id; });
    if (found == document.loads.end())
        return unknown(load.id.value);
    *found = load;
    return document;
}

Result<Document> removeLoad(Document document, LoadId id)
{
    if (std::erase_if(document.loads, [id](const Load &load) { return load.id == id; }) == 0)
        return unknown(id.value);
    return document;
}

} // namespace fff
