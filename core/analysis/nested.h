// The stage of the sheets: how parts lie on them, where somebody wants to see it. Export writes
// what lies here.
#pragma once

#include "core/analysis/cutting.h"
#include "core/analysis/stage.h"
#include "core/model/sheet_wishes.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

enum class NestLevel {
    Quick, // where there is room; what an edit has not changed stays where it lies
    Good,  // with kGoodSeconds of work
    Best,  // in rounds of more and more work, for whoever asks for the next one (sheet_nesting.h)
};

/// Seconds of a person's time, which become work by nest::workOf().
inline constexpr double kGoodSeconds = 10.0, kMostRoundSeconds = 160.0;
/// Of a round of Best, from 0 on.
double secondsOfRound(int round);

struct SheetsQuestion
{
    /// Its work is the level's; which parts are pinned, and how each may be turned, says the
    /// document.
    NestOptions nesting;
    bool compensatesKerf = true;
    NestLevel level = NestLevel::Quick;
    int round = 0; // of Best
    int times = 0; // asked anew: nothing that lies already is looked at

    /// But for the level: how long to search, not for what.
    bool asksForTheSame(const SheetsQuestion &other) const;
};

/// Empty where nobody asks. Where nothing can be cut, `why` says so in place of the cutting.
struct Nested
{
    std::shared_ptr<const SheetsQuestion> question;
    AnalysisPointer analysis; // that the parts are of
    std::optional<Error> why;
    std::shared_ptr<const CutParts> parts;
    std::shared_ptr<const Layout> layout;   // of these
    std::shared_ptr<const Cutting> cutting; // that comes of it
    double filled = 0.0;                    // filledShare()
    double cutLength = 0.0;                 // mm
    std::vector<int> loosened;              // parts that were to stay and could not
    /// Where pinned parts lay before somebody put them elsewhere: they go back there when they are
    /// pinned no more.
    std::vector<PinnedPlace> layBefore;
    bool isStopped = false; // before it had searched as long as it was to

    /// Lies as it does for as long as this is asked.
    bool answers(const SheetsQuestion &asked) const
    {
        return question && question->asksForTheSame(asked);
    }
};

inline constexpr StageOf<Nested> kNested{"sheets"};
/// Questions::sheets, which may be null. Given by itself: a search asks anew and anew, and what
/// else is asked goes on meanwhile.
inline constexpr StageOf<SheetsQuestion> kSheetsAsked{"sheets asked"};

/// Never worse than what lay of the same parts before, as long as the same is asked: fewer that fit
/// no sheet, then less taken of the sheets. Stopped: the best so far is given out, and never an
/// error.
///
/// Without anything before, the same parts, question and seed give the same. Quick goes by what lay
/// before: where few parts have changed, came or went, the others stay where they are, unless that
/// would take more sheets. So pinning a part moves no other.
Result<Nested> nested(const Snapshot &snapshot, const Nested *previous, Progress &progress,
                      std::stop_token stop);

} // namespace fff
