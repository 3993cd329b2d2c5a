#include "tests/bench/peer.h"

#include "core/io/document_file.h"

#include <QRegularExpression>
#include <QStringList>

namespace fff::bench {

namespace {

/// The words that tell a row: "comb of 50 ribs on a spine" is "comb of 50".
std::string keyOf(QString name)
{
    static const QRegularExpression tail(QStringLiteral(" ribs on a spine"));
    return name.remove(tail).simplified().toLower().toStdString();
}

QStringList cellsOf(const QString &line)
{
    QStringList cells;
    for (const QString &cell :
         line.mid(1, line.lastIndexOf(QLatin1Char('|')) - 1).split(QLatin1Char('|')))
        cells += cell.trimmed();
    return cells;
}

double numberIn(QString cell)
{
    return cell.remove(QLatin1Char(',')).toDouble();
}

} // namespace

const PeerRow *Peer::find(const std::string &name) const
{
    const auto it = rows.find(keyOf(QString::fromStdString(name)));
    return it == rows.end() ? nullptr : &it->second;
}

Result<Peer> readPeer(const QString &path)
{
    const Result<std::string> bytes = io::readFile(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const QString text = QString::fromStdString(*bytes);
    Peer peer;
    static const QRegularExpression kernel(QStringLiteral("kernel\\.cpp.*took ([0-9.]+) ms"),
                                           QRegularExpression::DotMatchesEverythingOption);
    peer.kernel = kernel.match(text).captured(1).toDouble();
    QStringList head;
    for (const QString &line : text.split(QLatin1Char('\n'))) {
        if (!line.startsWith(QLatin1Char('|')))
            continue;
        const QStringList cells = cellsOf(line);
        if (head.isEmpty()) {
            head = cells;
            continue;
        }
        const auto cell = [&](const char *column) {
            for (int i = 0; i < std::min(head.size(), cells.size()); ++i) {
                if (head[i].startsWith(QLatin1String(column)))
                    return numberIn(cells[i]);
            }
            return 0.0;
        };
        peer.rows[keyOf(cells.first())] = {cell("load"), cell("all slits"), cell("SVG"),
                                           cell("one drag move"), cell("physics")};
    }
    if (!(peer.kernel > 0.0) || peer.rows.empty())
        return failure(ErrorCode::BadSyntax, path.toStdString());
    return peer;
}

} // namespace fff::bench
