#include "core/io/picture_file.h"

#include "core/io/picture_header.h"

#include <QtCore/QBuffer>
#include <QtCore/QCoreApplication>
#include <QtGui/QColorSpace>
#include <QtGui/QImageReader>

#include <cmath>
#include <cstdint>

namespace fff::io {

namespace {

/// What programs write that know nothing of sizes is below: 72 and 96 pixels an inch.
constexpr double kLeastMeantPerInch = 100.0;
constexpr double kMillimetresPerInch = 25.4, kMillimetresPerMetre = 1000.0;

/// Qt refuses above a limit of its own, for all of the program: ours is known before.
void liftLimit()
{
    constexpr int kMostBytesPerPixel = 8, kMegabyte = 1 << 20;
    static const bool isLifted = [] {
        QImageReader::setAllocationLimit(
            static_cast<int>(kMostBytesPerPixel * kMostPicturePixels / kMegabyte + 1));
        return true;
    }();
    Q_UNUSED(isLifted)
}

double meantSize(const QImage &image)
{
    const double across = image.dotsPerMeterX(), down = image.dotsPerMeterY();
    const double perInch = across * kMillimetresPerInch / kMillimetresPerMetre;
    if (!(perInch >= kLeastMeantPerInch) || std::abs(across - down) > 1.0)
        return 0.0;
    return kMillimetresPerMetre / across;
}

TemplatePicturePointer pixelsOf(const QImage &image)
{
    auto picture = std::make_shared<TemplatePicture>();
    picture->width = image.width();
    picture->height = image.height();
    const auto row = 4 * static_cast<std::size_t>(image.width());
    picture->rgba.reserve(row * static_cast<std::size_t>(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        const uchar *line = image.constScanLine(y);
        picture->rgba.insert(picture->rgba.end(), line, line + row);
    }
    for (std::size_t i = 3; picture->isOpaque && i < picture->rgba.size(); i += 4)
        picture->isOpaque = picture->rgba[i] == 0xFF;
    return picture;
}

} // namespace

Result<void> checkedPixels(std::int64_t width, std::int64_t height, const std::string &name,
                           std::int64_t mostPixels)
{
    // Headers have 32 bits for each: the product of two such is no signed number any more.
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (pixels > static_cast<std::uint64_t>(mostPixels))
        return failure(ErrorCode::BadCount, name,
                       {std::to_string(pixels), std::to_string(mostPixels),
                        QT_TRANSLATE_NOOP("Error", "pixels")});
    return {};
}

Result<LoadedPicture> readPicture(std::string_view bytes, const std::string &name,
                                  std::int64_t mostPixels, const LongWork &work)
{
    const Result<PictureHeader> header = pictureHeader(bytes, name);
    if (!header)
        return tl::unexpected(header.error());
    if (Result<void> affordable = checkedPixels(header->width, header->height, name, mostPixels);
        !affordable)
        return tl::unexpected(std::move(affordable.error()));
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    liftLimit();
    QByteArray raw = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
    QBuffer buffer(&raw);
    // By what is in it: no other reader sees these bytes.
    QImageReader reader(&buffer, header->format);
    reader.setAutoDetectImageFormat(false);
    reader.setAutoTransform(true);
    if (!QImageReader::supportedImageFormats().contains(header->format))
        return failure(ErrorCode::Unsupported, name, {header->title});
    const QSize size = reader.size();
    if (size.isValid())
        if (Result<void> affordable = checkedPixels(size.width(), size.height(), name, mostPixels);
            !affordable)
            return tl::unexpected(std::move(affordable.error()));
    QImage image = reader.read();
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    if (image.isNull())
        return failure(ErrorCode::BadArchive, name,
                       {QT_TRANSLATE_NOOP("Error", "the picture is damaged")});
    LoadedPicture loaded;
    loaded.mediaType = header->mediaType;
    loaded.isAnimated = header->isAnimated;
    loaded.millimetresPerPixel = meantSize(image);
    const QColorSpace colours = image.colorSpace();
    image.convertTo(QImage::Format_RGBA8888);
    if (colours.isValid() && colours != QColorSpace(QColorSpace::SRgb)) {
        image.setColorSpace(colours);
        image.convertToColorSpace(QColorSpace::SRgb);
    }
    loaded.picture = pixelsOf(image);
    return loaded;
}

} // namespace fff::io
