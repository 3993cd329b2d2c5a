#include "ui/actions/search_words.h"

#include <QCoreApplication>

#include <algorithm>

namespace fff::ui {

namespace {

/// So that lupdate knows whose texts these are.
struct SearchTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::SearchWords)
public:
    static std::span<const SearchWords> all();
};

std::span<const SearchWords> SearchTexts::all()
{
    // Translations need not have as many words: what a person of that language would type.
    static constexpr SearchWords kAll[] = {
        {"file.new", QT_TR_NOOP("begin create empty blank")},
        {"file.open", QT_TR_NOOP("load import flatfab txt")},
        {"file.insert", QT_TR_NOOP("add merge append combine")},
        {"file.save", QT_TR_NOOP("store write")},
        {"file.saveAs", QT_TR_NOOP("copy rename")},
        {"file.revert", QT_TR_NOOP("reload discard")},
        {"file.export", QT_TR_NOOP("print laser cutter cnc plotter svg "
                                   "dxf pdf gcode lightburn make fabricate")},
        {"file.settings", QT_TR_NOOP("preferences options configure dark light theme "
                                     "language units inches mouse navigation autosave animation")},
        {"file.shortcuts", QT_TR_NOOP("keys hotkeys bindings")},
        {"file.quit", QT_TR_NOOP("exit leave")},
        {"section.importSections", QT_TR_NOOP("svg dxf import")},
        {"section.importContour", QT_TR_NOOP("svg dxf import")},
        {"section.importHoles", QT_TR_NOOP("svg dxf import")},
        {"section.importMarks", QT_TR_NOOP("svg dxf import engrave")},
        {"template.addMesh", QT_TR_NOOP("stl obj picture image photo trace reference background")},
        {"edit.undo", QT_TR_NOOP("back oops")},
        {"edit.redo", QT_TR_NOOP("again forward")},
        {"edit.copy", QT_TR_NOOP("clipboard")},
        {"edit.paste", QT_TR_NOOP("clipboard")},
        {"edit.duplicate", QT_TR_NOOP("copy clone")},
        {"edit.mirror", QT_TR_NOOP("flip reflect symmetric")},
        {"edit.delete", QT_TR_NOOP("remove erase trash")},
        {"edit.selectAll", QT_TR_NOOP("everything")},
        {"edit.find", QT_TR_NOOP("search palette")},
        {"view.fitAll", QT_TR_NOOP("zoom centre center home")},
        {"view.fitSelection", QT_TR_NOOP("zoom focus")},
        {"view.faceSelection", QT_TR_NOOP("look straight")},
        {"view.perspective", QT_TR_NOOP("orthographic isometric parallel camera")},
        {"view.xray", QT_TR_NOOP("transparent wireframe through")},
        {"view.clip", QT_TR_NOOP("slice inside half")},
        {"view.skin", QT_TR_NOOP("surface shell cover")},
        {"view.isolate", QT_TR_NOOP("solo alone")},
        {"view.showAll", QT_TR_NOOP("unhide visible")},
        {"view.hide", QT_TR_NOOP("invisible")},
        {"view.shadow", QT_TR_NOOP("grid floor")},
        {"value.handOn", QT_TR_NOOP("share give customizer customise customize configure student "
                                    "class adjust sliders locked full window")},
        {"view.fullScreen", QT_TR_NOOP("maximise maximize")},
        {"view.docks", QT_TR_NOOP("sidebars")},
        {"view.resetWindow", QT_TR_NOOP("layout default")},
        {"section.symmetry", QT_TR_NOOP("mirror half")},
        {"section.ground", QT_TR_NOOP("floor feet base")},
        {"section.snap", QT_TR_NOOP("magnet align guide")},
        {"section.pen", QT_TR_NOOP("polygon line curve bezier path")},
        {"section.addShape", QT_TR_NOOP("circle square rectangle polygon star")},
        {"section.mark", QT_TR_NOOP("engrave text letters etch label")},
        {"section.transform", QT_TR_NOOP("move rotate turn scale resize")},
        {"section.addHole", QT_TR_NOOP("opening window cutout")},
        {"section.redraw", QT_TR_NOOP("replace")},
        {"operation.linear", QT_TR_NOOP("array pattern repeat row ribs")},
        {"operation.revolve", QT_TR_NOOP("spin around")},
        {"operation.blend", QT_TR_NOOP("loft morph between")},
        {"operation.branch", QT_TR_NOOP("tree fork")},
        {"operation.grid", QT_TR_NOOP("waffle crate lattice")},
        {"operation.radial", QT_TR_NOOP("spokes wheel gear polar")},
        {"operation.rotational", QT_TR_NOOP("rotate polar pattern")},
        {"operation.array", QT_TR_NOOP("pattern repeat copies")},
        {"operation.slices", QT_TR_NOOP("waffle layers stl")},
        {"operation.bake", QT_TR_NOOP("convert explode apply")},
        {"check.nextProblem", QT_TR_NOOP("error warning issue")},
        {"check.showAssembly", QT_TR_NOOP("assembly instructions animation play manual")},
        {"check.stress", QT_TR_NOOP("strength break simulation physics fem")},
        {"physics.addWeight", QT_TR_NOOP("load mass force")},
        {"physics.addPush", QT_TR_NOOP("force load")},
        {"fabricate.stocks", QT_TR_NOOP("material thickness plywood acrylic kerf")},
        {"fabricate.coupon", QT_TR_NOOP("test piece kerf clearance slits comb")},
        {"fabricate.sheets", QT_TR_NOOP("nesting layout arrange")},
        {"measure.ruler", QT_TR_NOOP("length distance size dimension")},
        {"measure.dimension", QT_TR_NOOP("scale size resize")},
        {"help.firstSteps", QT_TR_NOOP("manual tutorial documentation guide")},
        {"help.start", QT_TR_NOOP("home welcome examples")},
        {"help.about", QT_TR_NOOP("version licence license")},
    };
    return kAll;
}

} // namespace

std::span<const SearchWords> searchWords()
{
    return SearchTexts::all();
}

QString searchWordsOf(const QString &id)
{
    const auto all = SearchTexts::all();
    const auto row = std::find_if(all.begin(), all.end(), [&](const SearchWords &one) {
        return id == QLatin1String(one.id);
    });
    if (row == all.end())
        return {};
    const QString english = QLatin1String(row->words), own = SearchTexts::tr(row->words);
    return own == english ? own : own + u' ' + english;
}

} // namespace fff::ui
