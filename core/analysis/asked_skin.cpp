#include "core/analysis/asked_skin.h"

namespace fff {

namespace {

/// How much of the time the surface itself takes; the rest makes it ready to be drawn.
constexpr double kSurfaceShare = 0.6;

} // namespace

Result<AskedSkin> askedSkin(const Snapshot &snapshot, const AskedSkin *previous, Progress &progress,
                            std::stop_token stop)
{
    AskedSkin out;
    if (!snapshot.get(kQuestions).skin)
        return out;
    out.isAsked = true;
    out.sections = snapshot.get(kModel).sections();
    if (previous && previous->isAsked && previous->sections == out.sections)
        return *previous;
    Result<Skin> skin =
        skinOf(out.sections, {stop, [&](double share) { progress.set(kSurfaceShare * share); }});
    if (!skin)
        return tl::unexpected(std::move(skin.error()));
    out.skin = *std::move(skin);
    if (!out.skin.mesh)
        return out;
    auto shown = makeTemplateMesh(out.skin.mesh, {},
                                  {std::move(stop), [&](double share) {
                                       progress.set(kSurfaceShare + (1.0 - kSurfaceShare) * share);
                                   }});
    if (!shown)
        return tl::unexpected(std::move(shown.error()));
    out.shown = *std::move(shown);
    return out;
}

} // namespace fff
