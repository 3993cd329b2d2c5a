#include "ui/view/view_style.h"

#include <QString>

#include <initializer_list>

namespace fff::ui {

namespace {

struct NamedLook
{
    std::initializer_list<QLatin1StringView> words; // all of them, in the name
    QRgb face, side;
    double alpha;
};

} // namespace

StockLook stockLook(const Stock &stock)
{
    // The first that fits counts, so the more special ones come first. Names are typed in
    // the languages of the window.
    static const NamedLook looks[] = {
        {{QLatin1StringView("acryl"), QLatin1StringView("red")}, 0xd9564a, 0xa53a31, 1.0},
        {{QLatin1StringView("acryl"), QLatin1StringView("rot")}, 0xd9564a, 0xa53a31, 1.0},
        {{QLatin1StringView("acryl")}, 0xbfdde8, 0x7fb2c6, 0.7},
        {{QLatin1StringView("basswood")}, 0xf0e2c4, 0xc9af86, 1.0},
        {{QLatin1StringView("linde")}, 0xf0e2c4, 0xc9af86, 1.0},
        {{QLatin1StringView("mdf")}, 0xb99470, 0x8f6e4e, 1.0},
        {{QLatin1StringView("corrugated")}, 0xcfa878, 0xa8804f, 1.0},
        {{QLatin1StringView("wellpappe")}, 0xcfa878, 0xa8804f, 1.0},
        {{QLatin1StringView("pom")}, 0xedeff1, 0xbcc3c9, 1.0},
        {{QLatin1StringView("alumin")}, 0xc3c9cf, 0x8e979f, 1.0},
        {{QLatin1StringView("plywood")}, 0xebd3a6, 0xb58a58, 1.0},
        {{QLatin1StringView("birch")}, 0xebd3a6, 0xb58a58, 1.0},
        {{QLatin1StringView("holz")}, 0xebd3a6, 0xb58a58, 1.0},
        {{QLatin1StringView("birke")}, 0xebd3a6, 0xb58a58, 1.0},
        {{QLatin1StringView("wood")}, 0xebd3a6, 0xb58a58, 1.0},
    };
    const QString name = QString::fromStdString(stock.name);
    for (const NamedLook &look : looks) {
        bool fits = true;
        for (QLatin1StringView word : look.words)
            fits = fits && name.contains(word, Qt::CaseInsensitive);
        if (fits)
            return {QColor(look.face), QColor(look.side), look.alpha};
    }
    return {QColor(0xd9, 0xdc, 0xdd), QColor(0xa9, 0xae, 0xb1), 1.0};
}

} // namespace fff::ui
