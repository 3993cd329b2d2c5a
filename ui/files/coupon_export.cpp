#include "ui/files/coupon_export.h"

#include "core/fabrication/fit_coupon.h"
#include "core/io/coupon_words.h"
#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "ui/base/file_dialog.h"
#include "ui/bench/workbench.h"
#include "ui/files/failures.h"
#include "ui/files/format_filters.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <vector>

namespace fff::ui {

namespace {

struct CouponExportTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::CouponExport)
};

/// Of sections; of a model without any, that of the next one.
std::vector<Stock> stocksToTry(const Model &model)
{
    std::vector<Stock> stocks;
    for (const auto &stock : model.document.stocks) {
        bool isUsed = model.sectionCount() == 0 && stock->id == model.document.currentStock;
        for (std::size_t i = 0; i < model.sectionCount() && !isUsed; ++i)
            isUsed = model.section(i)->stock == stock->id;
        if (isUsed)
            stocks.push_back(*stock);
    }
    return stocks;
}

/// What a machine follows, in the usual way of each format; that of Export first.
std::vector<ExportKind> couponKinds(const ExportChoices &choices)
{
    std::vector<ExportKind> kinds;
    for (const ExportKind &kind : exportKinds())
        if (kind.use == io::FileUse::Cutting && !kind.isFilePerSheet && kind.values.empty())
            kinds.push_back(kind);
    const QString last = choices.file.section(u'/', 0, 0);
    std::stable_partition(kinds.begin(), kinds.end(),
                          [&last](const ExportKind &kind) { return kind.key == last; });
    return kinds;
}

} // namespace

std::optional<CouponOutcome> CouponExport::ask(const QString &suggestion) const
{
    const std::vector<ExportKind> kinds = couponKinds(choices);
    QStringList filters;
    for (const ExportKind &kind : kinds)
        filters += kind.filter;
    const QFileInfo model(suggestion);
    FileDialog dialog(&window, CouponExportTexts::tr("Write a fit coupon"), model.absolutePath(),
                      filters.join(QStringLiteral(";;")));
    const auto suffixOf = [&](const QString &filter) {
        return kinds[static_cast<std::size_t>(std::max<qsizetype>(0, filters.indexOf(filter)))]
            .format->suffix();
    };
    //: %1 is a model's name: what the file of its test piece is called
    const QString name = CouponExportTexts::tr("%1 coupon").arg(model.fileName());
    dialog.setObjectName(QStringLiteral("couponFileDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffixOf(filters.front()));
    dialog.selectFile(name + u'.' + suffixOf(filters.front()));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString &filter) {
        dialog.setDefaultSuffix(suffixOf(filter));
        dialog.selectFile(name + u'.' + suffixOf(filter));
    });
    const QString path = dialog.target();
    return path.isEmpty() ? std::nullopt : std::optional(write(path));
}

CouponOutcome CouponExport::write(const QString &path) const
{
    const io::Format *named =
        io::formatWritten(QFileInfo(path).suffix(), &io::Format::writesCutting);
    const io::Format &format = named ? *named : *couponKinds(choices).front().format;
    const Result<void> written =
        fitCoupon(stocksToTry(bench.session().committed()), choices.chosenMachine(),
                  io::couponWords())
            .and_then([&](const CuttingDrawing &coupon) { return format.writeCutting(coupon, {}); })
            .and_then([&](const std::string &bytes) { return io::writeFile(path, bytes); });
    if (!written)
        return {false, saveFailure(path, written.error()), failureDetails(path, written.error())};
    //: %1 is the name of a file
    return {true,
            CouponExportTexts::tr("Wrote a fit coupon to %1. Cut it and push the strip into its "
                                  "slits; Export asks which one fitted.")
                .arg(QFileInfo(path).fileName()),
            {}};
}

} // namespace fff::ui
