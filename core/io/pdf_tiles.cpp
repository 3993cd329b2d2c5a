#include "core/io/pdf_tiles.h"

#include <algorithm>
#include <cmath>

namespace fff::io {

namespace {

int countAlong(double length, double room)
{
    const double step = room - kPaperOverlap;
    return std::max(1, static_cast<int>(std::ceil((length - kPaperOverlap) / step)));
}

PdfTiles tilesOn(const Box2 &box, const Vec2 &paper)
{
    PdfTiles all;
    all.paper = paper;
    const Vec2 room = all.room();
    all.columns = countAlong(box.size().x(), room.x());
    all.rows = countAlong(box.size().y(), room.y());
    return all;
}

} // namespace

std::string PdfTile::name() const
{
    constexpr int kLetters = 26;
    std::string letters;
    for (int left = column + 1; left > 0; left = (left - 1) / kLetters)
        letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % kLetters));
    return letters + std::to_string(row + 1);
}

Vec2 PdfTiles::room() const
{
    return paper - Vec2::Constant(kPaperMargin) - low();
}

PdfTiles tilesOver(const Box2 &box, const Vec2 &paper)
{
    const PdfTiles upright = tilesOn(box, paper), turned = tilesOn(box, {paper.y(), paper.x()});
    PdfTiles all = turned.columns * turned.rows < upright.columns * upright.rows ? turned : upright;
    const Vec2 room = all.room(), step = room - Vec2::Constant(kPaperOverlap);
    const Vec2 covered =
        step.cwiseProduct(Vec2(all.columns, all.rows)) + Vec2::Constant(kPaperOverlap);
    const Vec2 corner = box.center() - 0.5 * covered;
    for (int row = 0; row < all.rows; ++row)
        for (int column = 0; column < all.columns; ++column)
            all.tiles.push_back(
                {column, row, corner + step.cwiseProduct(Vec2(column, all.rows - 1 - row))});
    return all;
}

} // namespace fff::io
