#include "app/cli/nest.h"

#include "core/io/json_writer.h"
#include "core/io/nesting_instance.h"
#include "core/nesting/nester.h"

#include <QCoreApplication>

#include <string>

namespace fff::cli {

namespace {

using io::JsonWriter;
using nest::Turning;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

std::string instanceJson(const io::NestingInstance &instance, const nest::Solution &solution)
{
    JsonWriter json;
    json.beginObject();
    json.member("instance", instance.name);
    json.member("length", solution.length);
    json.member("density", solution.density);
    json.key("items");
    json.beginArray();
    for (const nest::Place &place : solution.places) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("id", instance.ids[static_cast<std::size_t>(place.piece)]);
        json.member("rotation", degreesOf(place.turn));
        json.member("at", place.offset);
        json.endObject();
    }
    json.endArray();
    json.member("seconds", secondsOf(solution.work));
    json.endObject();
    return json.take();
}

} // namespace

int nestInstance(const QString &file, const NestAsked &asked)
{
    const Result<std::string> bytes = io::readFile(file);
    if (!bytes)
        return report(bytes.error());
    Result<io::NestingInstance> instance = io::readNestingInstance(*bytes, file.toStdString());
    if (!instance)
        return report(instance.error());
    nest::Problem &problem = instance->problem;
    problem.margin = asked.margin.value_or(0.0);
    problem.spacing = asked.spacing.value_or(0.0);
    for (nest::Piece &piece : problem.pieces) {
        if (!asked.turning)
            continue;
        piece.turns = nest::turnsOf(*asked.turning);
        piece.turnsFreely = *asked.turning == Turning::Free;
    }
    const NestGuard guard(asked.seconds);
    const nest::Solution solution =
        nest::nestPieces(problem, {asked.seed, nest::workOf(asked.seconds), true}, guard.work());
    if (!solution.left.empty()) {
        const auto piece = static_cast<std::size_t>(solution.left.front());
        //: %1 is a file and a place in it
        printError(tr("%1: this item is too large for the strip.")
                       .arg(QStringLiteral("%1:$.items[%2]").arg(file, QString::number(piece))));
        return BadInput;
    }
    if (asked.asJson)
        return print(instanceJson(*instance, solution));
    return printLines({tr("Length: %1").arg(QString::number(solution.length)),
                       tr("Density: %1 %").arg(QString::number(100.0 * solution.density, 'f', 2))});
}

} // namespace fff::cli
