#include "ui/bench/clipboard.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

namespace fff::ui {

namespace {

/// So that a program that knows models need not guess what a text is.
constexpr const char *kType = "application/x-flatfitfab+json";

} // namespace

std::string modelTextIn(const QMimeData &data)
{
    const QString type = QLatin1String(kType);
    return data.hasFormat(type) ? data.data(type).toStdString() : data.text().toStdString();
}

Clipboard systemClipboard()
{
    const auto read = [] {
        const QMimeData *data = QGuiApplication::clipboard()->mimeData();
        return data ? modelTextIn(*data) : std::string();
    };
    const auto write = [](const std::string &text) {
        auto *data = new QMimeData; // the clipboard's from then on
        data->setData(QLatin1String(kType), QByteArray::fromStdString(text));
        data->setText(QString::fromStdString(text));
        QGuiApplication::clipboard()->setMimeData(data);
    };
    return {read, write};
}

} // namespace fff::ui
