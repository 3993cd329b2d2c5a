// What export is told of cuts: their tabs, leads and neighbours, and the fit coupon.
#pragma once

#include "app/cli/command_line.h"
#include "core/fabrication/cutting_drawing.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {
struct Machine;
}

namespace fff::cli {

/// --tabs, --lead, --common-lines, --coupon.
void addCutOptions(QCommandLineParser &parser);

/// Nothing where none is given: the machine's. why: where one makes no sense.
std::optional<CutFinish> finishAsked(const QCommandLineParser &parser, const Machine *machine,
                                     QString &why);

/// A sentence where margins leave nothing of any sheet of a stock: no part can be laid on one.
QString whyNoRoom(const std::vector<Stock> &stocks, const LayoutOptions &options);

/// How much is cut once for two parts, where that is asked for: also that it is nothing.
void explainSharedCuts(const CuttingDrawing &drawing);

/// Which parts have a cut without the lead that is asked for.
void explainLeads(const CuttingDrawing &drawing);

/// Writes a fit coupon for the stocks that sections are cut from, and says what its slits mean. The
/// format writes cutting files. Returns the exit status.
int writeCoupon(const io::Format &format, const io::FormatValues &values, const QString &path,
                const Document &document, const std::shared_ptr<const Machine> &machine);

} // namespace fff::cli
