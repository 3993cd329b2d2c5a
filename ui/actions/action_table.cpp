#include "ui/actions/action_table.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

/// So that lupdate knows whose texts these are: it does not look into macros of our own.
struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ActionSet)
public:
    static std::span<const ActionRow> actions();
    static std::span<const MenuRow> menus();
};

std::span<const ActionRow> Texts::actions()
{
    static const ActionRow kActions[] = {
        {"file.new", QT_TR_NOOP("&New"), QT_TR_NOOP("New"), "Ctrl+N", "new",
         QT_TR_NOOP("Start a new model")},
        {"file.open", QT_TR_NOOP("&Open…"), QT_TR_NOOP("Open"), "Ctrl+O", "open",
         QT_TR_NOOP("Open a model, also one of FlatFab")},
        {"file.insert", QT_TR_NOOP("&Insert model…"), QT_TR_NOOP("Insert"), "Ctrl+Shift+I",
         "insert_model", QT_TR_NOOP("Add the sections of another model to this one")},
        {"file.addToLibrary", QT_TR_NOOP("Add to the &library"), QT_TR_NOOP("To library"), "",
         "keep", QT_TR_NOOP("Keep what is selected in the library, for other models")},
        {"file.save", QT_TR_NOOP("&Save"), QT_TR_NOOP("Save"), "Ctrl+S", "save",
         QT_TR_NOOP("Save the model")},
        {"file.saveAs", QT_TR_NOOP("Save &as…"), QT_TR_NOOP("Save as"), "Ctrl+Shift+S", "save_as",
         QT_TR_NOOP("Save the model under another name")},
        {"file.export", QT_TR_NOOP("&Export cutting files…"), QT_TR_NOOP("Export…"), "Ctrl+Shift+E",
         "export", QT_TR_NOOP("Write the parts to a file for the laser cutter")},
        {"file.revert", QT_TR_NOOP("Re&vert to saved"), QT_TR_NOOP("Revert"), "", "revert",
         QT_TR_NOOP("Go back to the model as it is in its file; Undo brings the changes back")},
        {"file.settings", QT_TR_NOOP("Se&ttings…"), QT_TR_NOOP("Settings"), "Ctrl+,", "settings",
         QT_TR_NOOP("Units, colours, language, files and shortcuts")},
        {"file.close", QT_TR_NOOP("&Close window"), QT_TR_NOOP("Close"), "Ctrl+W", "close_window",
         QT_TR_NOOP("Close this window; others stay open")},
        {"file.quit", QT_TR_NOOP("&Quit"), QT_TR_NOOP("Quit"), "Ctrl+Q", "quit",
         QT_TR_NOOP("Close all windows and the program")},
        {"edit.undo", QT_TR_NOOP("&Undo"), QT_TR_NOOP("Undo"), "Ctrl+Z", "undo",
         QT_TR_NOOP("Take the last step back")},
        {"edit.redo", QT_TR_NOOP("&Redo"), QT_TR_NOOP("Redo"), "Ctrl+Shift+Z Ctrl+Y", "redo",
         QT_TR_NOOP("Do the step again that was taken back")},
        {"edit.cut", QT_TR_NOOP("Cu&t"), QT_TR_NOOP("Cut"), "Ctrl+X", "cut",
         QT_TR_NOOP("Copy the selected sections and delete them")},
        {"edit.copy", QT_TR_NOOP("&Copy"), QT_TR_NOOP("Copy"), "Ctrl+C", "copy",
         QT_TR_NOOP("Copy the selected sections, also for other windows and programs")},
        {"edit.paste", QT_TR_NOOP("&Paste"), QT_TR_NOOP("Paste"), "Ctrl+V", "paste",
         QT_TR_NOOP("Add the sections that were copied")},
        {"edit.duplicate", QT_TR_NOOP("Dup&licate"), QT_TR_NOOP("Duplicate"), "Ctrl+D", "duplicate",
         QT_TR_NOOP("Put a copy of the selected sections beside them")},
        {"edit.delete", QT_TR_NOOP("&Delete"), QT_TR_NOOP("Delete"), "Del", "trash",
         QT_TR_NOOP("Delete the selected sections")},
        {"edit.selectAll", QT_TR_NOOP("Select &all"), QT_TR_NOOP("Select all"), "Ctrl+A",
         "select_all", QT_TR_NOOP("Select all sections")},
        {"edit.selectNext", QT_TR_NOOP("Select ne&xt"), QT_TR_NOOP("Next"), "PgDown", "move_down",
         QT_TR_NOOP("Select the next section"), true},
        {"edit.selectPrevious", QT_TR_NOOP("Select pre&vious"), QT_TR_NOOP("Previous"), "PgUp",
         "move_up", QT_TR_NOOP("Select the section before this one"), true},
        {"view.properties", QT_TR_NOOP("Go to Properties"), QT_TR_NOOP("Properties"), "",
         "settings",
         QT_TR_NOOP("To the first field of what is selected; in the view, Enter does so")},
        {"edit.mirrorCopyX", QT_TR_NOOP("Across &X"), QT_TR_NOOP("Mirror X"), "", "mirror_copy",
         QT_TR_NOOP("Put a mirror image of the selected sections on the other side of the plane "
                    "where X is 0")},
        {"edit.mirrorCopyY", QT_TR_NOOP("Across &Y"), QT_TR_NOOP("Mirror Y"), "", "mirror_copy",
         QT_TR_NOOP("Put a mirror image of the selected sections on the other side of the plane "
                    "where Y is 0")},
        {"edit.mirrorCopyZ", QT_TR_NOOP("Across &Z"), QT_TR_NOOP("Mirror Z"), "", "mirror_copy",
         QT_TR_NOOP("Put a mirror image of the selected sections on the other side of the plane "
                    "where Z is 0")},
        {"edit.mirrorCopySection", QT_TR_NOOP("Across a &section…"), QT_TR_NOOP("Mirror"), "",
         "mirror_copy",
         QT_TR_NOOP("Click a section: a mirror image of the selected ones comes on its other side"),
         false, true},
        {"edit.selectConnected", QT_TR_NOOP("Select co&nnected"), QT_TR_NOOP("Connected"),
         "Ctrl+Shift+A", "select_connected",
         QT_TR_NOOP("Select all sections that hang together with the selected ones")},
        {"edit.selectParallel", QT_TR_NOOP("&Select parallel"), QT_TR_NOOP("Parallel"), "",
         "select_parallel", QT_TR_NOOP("Select all sections parallel to the selected ones")},
        {"edit.selectSameStock", QT_TR_NOOP("Select of the same stoc&k"), QT_TR_NOOP("Same stock"),
         "", "stocks", QT_TR_NOOP("Select all sections of the stocks of the selected ones")},
        {"view.front", QT_TR_NOOP("&Front"), QT_TR_NOOP("Front"), "1", "view_front",
         QT_TR_NOOP("Look from the front"), true},
        {"view.top", QT_TR_NOOP("&Top"), QT_TR_NOOP("Top"), "2", "view_top",
         QT_TR_NOOP("Look from the top"), true},
        {"view.right", QT_TR_NOOP("&Right"), QT_TR_NOOP("Right"), "3", "view_right",
         QT_TR_NOOP("Look from the right"), true},
        {"view.back", QT_TR_NOOP("&Back"), QT_TR_NOOP("Back"), "4", "view_back",
         QT_TR_NOOP("Look from the back"), true},
        {"view.bottom", QT_TR_NOOP("Botto&m"), QT_TR_NOOP("Bottom"), "5", "view_bottom",
         QT_TR_NOOP("Look from below"), true},
        {"view.left", QT_TR_NOOP("&Left"), QT_TR_NOOP("Left"), "6", "view_left",
         QT_TR_NOOP("Look from the left"), true},
        {"view.iso", QT_TR_NOOP("Next &corner"), QT_TR_NOOP("Corner"), "0", "view_iso",
         QT_TR_NOOP("Look from the next corner"), true},
        {"view.faceSelection", QT_TR_NOOP("Face the &section"), QT_TR_NOOP("Face"), "N",
         "face_section", QT_TR_NOOP("Look straight at the selected section"), true},
        {"view.fitAll", QT_TR_NOOP("Fit &everything"), QT_TR_NOOP("Fit"), "Home", "fit",
         QT_TR_NOOP("Show the whole model"), true},
        {"view.fitSelection", QT_TR_NOOP("F&it selection"), QT_TR_NOOP("Fit selection"), "F",
         "fit_selection", QT_TR_NOOP("Show the selected sections as large as possible"), true},
        {"view.previous", QT_TR_NOOP("&Previous view"), QT_TR_NOOP("Previous"), "Alt+Left",
         "view_previous", QT_TR_NOOP("Go back to the view before this one")},
        {"view.perspective", QT_TR_NOOP("Perspecti&ve"), QT_TR_NOOP("Perspective"), "V",
         "perspective", QT_TR_NOOP("Show what is farther away smaller, as the eye sees it"), true,
         true},
        {"view.xray", QT_TR_NOOP("&X-ray"), QT_TR_NOOP("X-ray"), "X", "xray",
         QT_TR_NOOP("See through all sections, down to their slits"), true, true},
        {"view.isolate", QT_TR_NOOP("Onl&y the selection"), QT_TR_NOOP("Isolate"), "I", "isolate",
         QT_TR_NOOP("Let all other sections stand back"), true, true},
        {"view.hide", QT_TR_NOOP("&Hide"), QT_TR_NOOP("Hide"), "H", "hide",
         QT_TR_NOOP("Hide the selected sections"), true},
        {"view.showAll", QT_TR_NOOP("Show &all"), QT_TR_NOOP("Show all"), "Shift+H", "show_all",
         QT_TR_NOOP("Show the hidden sections again"), true},
        {"view.clip", QT_TR_NOOP("Cut view &open"), QT_TR_NOOP("Cut open"), "C", "cut_open",
         QT_TR_NOOP("Cut the model open with a plane, to look inside"), true, true},
        {"view.shadow", QT_TR_NOOP("&Ground and shadow"), QT_TR_NOOP("Ground"), "", "ground_shadow",
         QT_TR_NOOP("Show the ground with its grid and the model's shadow"), false, true},
        {"view.docks", QT_TR_NOOP("Hide all doc&ks"), QT_TR_NOOP("Hide docks"), "F9", "docks",
         QT_TR_NOOP("Hide or show the panels at the sides"), false, true},
        {"view.fullScreen", QT_TR_NOOP("F&ull screen"), QT_TR_NOOP("Full screen"), "F11",
         "full_screen", QT_TR_NOOP("Fill the screen with the window"), false, true},
        {"view.resetWindow", QT_TR_NOOP("Reset &window"), QT_TR_NOOP("Reset window"), "",
         "reset_window", QT_TR_NOOP("Put all panels back where they were at first")},
        {"view.nextPane", QT_TR_NOOP("&Next part of the window"), QT_TR_NOOP("Next part"), "F6",
         "next_pane", QT_TR_NOOP("Go to the next part of the window: tool bar, left, view, right")},
        {"view.previousPane", QT_TR_NOOP("Previous part of the win&dow"),
         QT_TR_NOOP("Previous part"), "Shift+F6", "previous_pane",
         QT_TR_NOOP("Go back to the part of the window before this one")},
        {"section.symmetry", QT_TR_NOOP("Local &symmetry"), QT_TR_NOOP("Symmetry"), "S", "symmetry",
         QT_TR_NOOP("Mirror a contour across its slit when it is drawn on one side of it"), true,
         true},
        {"section.ground", QT_TR_NOOP("Cut flat at the &ground"), QT_TR_NOOP("Ground"), "G",
         "cut_at_ground", QT_TR_NOOP("Cut off what is drawn below the ground"), true, true},
        {"section.snap", QT_TR_NOOP("S&nap"), QT_TR_NOOP("Snap"), "Q", "snap",
         QT_TR_NOOP("Draw points to others, to lines level and upright with them, and to the grid"),
         true, true},
        {"section.pen", QT_TR_NOOP("P&en"), QT_TR_NOOP("Pen"), "P", "pen",
         QT_TR_NOOP("Draw with clicks in place of one stroke: set points, drag to bend"), true,
         true},
        {"section.planeGround", QT_TR_NOOP("On the gr&ound"), QT_TR_NOOP("On the ground"), "L",
         "plane_ground", QT_TR_NOOP("Draw a section that lies on the ground"), true, true},
        {"section.planeFront", QT_TR_NOOP("On the &front plane"), QT_TR_NOOP("On the front"), "",
         "plane_front", QT_TR_NOOP("Draw a section upright in the middle, seen from the front"),
         true, true},
        {"section.planeSide", QT_TR_NOOP("On the s&ide plane"), QT_TR_NOOP("On the side"), "",
         "plane_side", QT_TR_NOOP("Draw a section upright in the middle, seen from the side"), true,
         true},
        {"section.planeParallel", QT_TR_NOOP("&Parallel to the section"), QT_TR_NOOP("Parallel"),
         "", "plane_parallel", QT_TR_NOOP("Draw a section parallel to the selected one"), true,
         true},
        {"section.redraw", QT_TR_NOOP("&Redraw contour"), QT_TR_NOOP("Redraw"), "R", "redraw",
         QT_TR_NOOP("Draw a new contour for the selected section"), true, true},
        {"section.addHole", QT_TR_NOOP("Draw a &hole"), QT_TR_NOOP("Hole"), "O", "hole",
         QT_TR_NOOP("Draw a hole in the selected section"), true, true},
        {"section.addShape", QT_TR_NOOP("&Draw a shape"), QT_TR_NOOP("Shape"), "Shift+A",
         "figure_draw", QT_TR_NOOP("Drag a circle, rectangle or the like out of its middle"), true,
         true},
        {"section.addCircle", QT_TR_NOOP("&Circle"), QT_TR_NOOP("Circle"), "", "figure_circle",
         QT_TR_NOOP("By numbers: a hole in the selected section, or a section of its own")},
        {"section.addEllipse", QT_TR_NOOP("&Ellipse"), QT_TR_NOOP("Ellipse"), "", "figure_ellipse",
         QT_TR_NOOP("By numbers: a hole in the selected section, or a section of its own")},
        {"section.addRectangle", QT_TR_NOOP("&Rectangle"), QT_TR_NOOP("Rectangle"), "",
         "figure_rectangle",
         QT_TR_NOOP("By numbers: a hole in the selected section, or a section of its own")},
        {"section.addPolygon", QT_TR_NOOP("&Polygon"), QT_TR_NOOP("Polygon"), "", "figure_polygon",
         QT_TR_NOOP("By numbers: a hole in the selected section, or a section of its own")},
        {"section.addStar", QT_TR_NOOP("&Star"), QT_TR_NOOP("Star"), "", "figure_star",
         QT_TR_NOOP("By numbers: a hole in the selected section, or a section of its own")},
        {"section.addSlot", QT_TR_NOOP("S&lot"), QT_TR_NOOP("Slot"), "", "figure_slot",
         QT_TR_NOOP("By numbers: a hole in the selected section, or a section of its own")},
        {"section.removeHoles", QT_TR_NOOP("Re&move holes"), QT_TR_NOOP("No holes"), "",
         "holes_remove", QT_TR_NOOP("Close all holes of the selected sections"), true},
        {"point.insert", QT_TR_NOOP("&Add point"), QT_TR_NOOP("Add point"), "+", "point_add",
         QT_TR_NOOP("Add a control point under the cursor, or beside the selected one"), true},
        {"point.delete", QT_TR_NOOP("De&lete point"), QT_TR_NOOP("Delete point"), "-",
         "point_remove", QT_TR_NOOP("Delete the selected control points"), true},
        {"point.smooth", QT_TR_NOOP("Smoo&th point"), QT_TR_NOOP("Smooth"), "Ctrl+1",
         "point_smooth", QT_TR_NOOP("Let the contour run smoothly through the selected points")},
        {"point.symmetric", QT_TR_NOOP("S&ymmetric point"), QT_TR_NOOP("Symmetric"), "Ctrl+3",
         "point_symmetric", QT_TR_NOOP("The same with handles of equal length to both sides")},
        {"point.corner", QT_TR_NOOP("&Corner point"), QT_TR_NOOP("Corner"), "Ctrl+2",
         "point_corner", QT_TR_NOOP("Make the selected points corners")},
        {"joint.flip", QT_TR_NOOP("Flip the slits of the &joint"), QT_TR_NOOP("Flip the slits"), "",
         "joint_flip", QT_TR_NOOP("Let the slits of the selected joint open to the other side")},
        {"section.importSections", QT_TR_NOOP("&New sections…"), QT_TR_NOOP("From SVG"), "",
         "import_drawing", QT_TR_NOOP("A section for every outline of a drawing")},
        {"section.importContour", QT_TR_NOOP("&Contour…"), QT_TR_NOOP("Contour from SVG"), "",
         "import_drawing",
         QT_TR_NOOP("The largest outline of a drawing in place of the selected section's")},
        {"section.importHoles", QT_TR_NOOP("&Holes…"), QT_TR_NOOP("Holes from SVG"), "",
         "import_drawing",
         QT_TR_NOOP("A hole of the selected section for every outline of a drawing")},
        {"section.importMarks", QT_TR_NOOP("&Marks…"), QT_TR_NOOP("Marks from SVG"), "",
         "import_drawing",
         QT_TR_NOOP("The lines of a drawing, engraved or scored on the selected section")},
        {"section.mark", QT_TR_NOOP("Add te&xt or lines to engrave"), QT_TR_NOOP("Engrave"), "E",
         "engrave", QT_TR_NOOP("Write or draw on a section, to be engraved or scored"), true, true},
        {"mark.engrave", QT_TR_NOOP("&Engrave"), QT_TR_NOOP("Engrave"), "", "engrave",
         QT_TR_NOOP("What is drawn next is engraved"), false, true},
        {"mark.score", QT_TR_NOOP("&Score"), QT_TR_NOOP("Score"), "", "score",
         QT_TR_NOOP("What is drawn next is scored, to fold or break along"), false, true},
        {"measure.ruler", QT_TR_NOOP("M&easure"), QT_TR_NOOP("Measure"), "M", "measure",
         QT_TR_NOOP("Measure from one place to another"), true, true},
        {"measure.dimension", QT_TR_NOOP("D&imension"), QT_TR_NOOP("Dimension"), "D", "dimension",
         QT_TR_NOOP("Say how long something shall be; the whole model follows"), true, true},
        {"measure.keep", QT_TR_NOOP("Keep t&he dimension"), QT_TR_NOOP("Keep"), "", "keep",
         QT_TR_NOOP("Show this length from now on")},
        {"measure.remove", QT_TR_NOOP("Rem&ove the dimension"), QT_TR_NOOP("Remove"), "", "trash",
         QT_TR_NOOP("Show this length no more")},
        {"joint.reset", QT_TR_NOOP("Reset the joint to a&utomatic"), QT_TR_NOOP("Reset joint"), "",
         "joint_reset",
         QT_TR_NOOP("Let the selected joint be as it is by itself: kind, direction and share")},
        {"section.transform", QT_TR_NOOP("Move &and turn"), QT_TR_NOOP("Move"), "T", "transform",
         QT_TR_NOOP("Move, turn and scale with handles or numbers"), true, true},
        {"transform.inSpace", QT_TR_NOOP("&In space"), QT_TR_NOOP("In space"), "", "in_space",
         QT_TR_NOOP("Along the axes of the world, rather than in the plane of the section"), false,
         true},
        {"transform.withChildren", QT_TR_NOOP("&With what is on it"), QT_TR_NOOP("With all on it"),
         "", "with_children",
         QT_TR_NOOP("What was drawn on a section goes along when that is moved"), false, true},
        {"section.putOn", QT_TR_NOOP("&Put on another section…"), QT_TR_NOOP("Put on"), "",
         "put_on", QT_TR_NOOP("Click the section that the selected one shall be on"), false, true},
        {"section.free", QT_TR_NOOP("Free &from its parent"), QT_TR_NOOP("Free"), "", "free",
         QT_TR_NOOP("Let the section go any way: it neither goes along with the one that it is on, "
                    "nor keeps its angle"),
         false, true},
        {"section.makeOrthogonal", QT_TR_NOOP("Ma&ke orthogonal"), QT_TR_NOOP("Orthogonal"), "",
         "orthogonal", QT_TR_NOOP("Turn the section to a right angle to the one that it is on")},
        {"section.snapNormal", QT_TR_NOOP("Align to nearest a&xis"), QT_TR_NOOP("Align"), "",
         "align", QT_TR_NOOP("Turn the section so that it faces along an axis of the world")},
        {"section.lock", QT_TR_NOOP("Lo&ck"), QT_TR_NOOP("Lock"), "", "lock",
         QT_TR_NOOP("Let the selected sections stay as they are"), false, true},
        {"section.dropToGround", QT_TR_NOOP("&Drop to ground"), QT_TR_NOOP("Drop"), "End",
         "drop_to_ground", QT_TR_NOOP("Set the model down on the ground"), true},
        {"operation.linear", QT_TR_NOOP("&Linear"), QT_TR_NOOP("Linear"), "Ctrl+L", "linear",
         QT_TR_NOOP("Repeat a section in a row along another one"), false, true},
        {"operation.revolve", QT_TR_NOOP("&Revolve along contour"), QT_TR_NOOP("Revolve"), "Ctrl+R",
         "revolve", QT_TR_NOOP("Repeat a section round the contour of another one"), false, true},
        {"operation.blend", QT_TR_NOOP("&Blend"), QT_TR_NOOP("Blend"), "Ctrl+E", "blend",
         QT_TR_NOOP("Make sections between others, which turn into one another"), false, true},
        {"operation.branch", QT_TR_NOOP("Br&anch"), QT_TR_NOOP("Branch"), "Ctrl+B", "branch",
         QT_TR_NOOP("Let a section grow out of itself again and again, as a tree does"), false,
         true},
        {"operation.grid", QT_TR_NOOP("&Grid with connectors"), QT_TR_NOOP("Grid"), "Ctrl+G",
         "grid", QT_TR_NOOP("Divide a section that is too large for the sheet"), false, true},
        {"operation.radial", QT_TR_NOOP("Ra&dial contour"), QT_TR_NOOP("Radial"), "Ctrl+Shift+R",
         "radial", QT_TR_NOOP("Make a circle, a star or a gear of a section, or holes in it"),
         false, true},
        {"operation.mirror", QT_TR_NOOP("&Mirror model"), QT_TR_NOOP("Mirror"), "Ctrl+Shift+M",
         "mirror", QT_TR_NOOP("Let what is drawn on one side stand on the other side, too"), false,
         true},
        {"operation.rotational", QT_TR_NOOP("Ro&tational symmetry"), QT_TR_NOOP("Rotational"), "",
         "rotational", QT_TR_NOOP("Let what is drawn once stand all round an axis"), false, true},
        {"operation.array", QT_TR_NOOP("Arra&y"), QT_TR_NOOP("Array"), "", "array",
         QT_TR_NOOP("Repeat sections along a line through space"), false, true},
        {"operation.symmetric", QT_TR_NOOP("Make symmetric &now"), QT_TR_NOOP("Symmetric"), "",
         "symmetry", QT_TR_NOOP("Copy what stands on one side to the other side, once")},
        {"operation.switch", QT_TR_NOOP("&Switch off or on"), QT_TR_NOOP("On"), "",
         "operation_switch", QT_TR_NOOP("Switch the selected operation off, or on again")},
        {"operation.moveUp", QT_TR_NOOP("Earlier in the &order"), QT_TR_NOOP("Earlier"), "",
         "move_up", QT_TR_NOOP("Let the selected operation work before the one above it")},
        {"operation.moveDown", QT_TR_NOOP("Lat&er in the order"), QT_TR_NOOP("Later"), "",
         "move_down", QT_TR_NOOP("Let the selected operation work after the one below it")},
        {"operation.editSource", QT_TR_NOOP("Edit &its source"), QT_TR_NOOP("Edit source"), "",
         "section", QT_TR_NOOP("Select the section that the selected one is made from")},
        {"operation.detach", QT_TR_NOOP("Deta&ch this one"), QT_TR_NOOP("Detach"), "", "detach",
         QT_TR_NOOP("Make a drawn section of the selected one; its operation makes the others")},
        {"operation.leaveOut", QT_TR_NOOP("Lea&ve this one out"), QT_TR_NOOP("Leave out"), "",
         "hide", QT_TR_NOOP("Do not make the selected section; its operation makes the others")},
        {"operation.bake", QT_TR_NOOP("Ba&ke into sections"), QT_TR_NOOP("Bake"), "", "bake",
         QT_TR_NOOP("Make drawn sections of what the selected operation makes")},
        {"check.nextProblem", QT_TR_NOOP("&Next problem"), QT_TR_NOOP("Next problem"), "F8",
         "next_problem", QT_TR_NOOP("Select the sections of the next problem and show them")},
        {"check.previousProblem", QT_TR_NOOP("&Previous problem"), QT_TR_NOOP("Previous problem"),
         "Shift+F8", "previous_problem",
         QT_TR_NOOP("Select the sections of the problem before this one")},
        {"check.showAssembly", QT_TR_NOOP("Show the &steps"), QT_TR_NOOP("Steps"), "A", "steps",
         QT_TR_NOOP("Show step by step how the model is put together"), true, true},
        {"fabricate.stocks", QT_TR_NOOP("&Stocks…"), QT_TR_NOOP("Stocks"), "", "stocks",
         QT_TR_NOOP("Sheet materials: thickness, strength, kerf and sheet size")},
        {"edit.find", QT_TR_NOOP("&Find an action…"), QT_TR_NOOP("Find"), "Ctrl+K", "search",
         QT_TR_NOOP("Type to find anything that the program can do")},
        {"help.start", QT_TR_NOOP("&Start page"), QT_TR_NOOP("Start page"), "", "start",
         QT_TR_NOOP("Recent models and samples")},
        {"help.about", QT_TR_NOOP("&About FlatFitFab"), QT_TR_NOOP("About"), "", "about",
         QT_TR_NOOP("What this program is, its version and its licences")},
    };
    return kActions;
}

std::span<const MenuRow> Texts::menus()
{
    static const MenuRow kMenus[] = {
        {QT_TR_NOOP("&File"),
         "file.new file.open @recent file.insert file.addToLibrary | file.save file.saveAs "
         "file.revert | file.export | "
         "file.settings | file.close file.quit"},
        {QT_TR_NOOP("&Edit"),
         "edit.undo edit.redo | edit.cut edit.copy edit.paste edit.duplicate edit.delete | "
         ">mirrorCopy | "
         "edit.selectAll edit.selectConnected edit.selectParallel edit.selectSameStock "
         "edit.selectNext edit.selectPrevious | "
         "measure.ruler measure.dimension measure.keep measure.remove"},
        {QT_TR_NOOP("&View"),
         "view.front view.top view.right view.back view.bottom view.left view.iso "
         "view.faceSelection | view.fitAll view.fitSelection "
         "view.previous | view.perspective view.xray view.clip view.shadow | "
         "view.isolate view.hide view.showAll | "
         "@docks view.docks view.resetWindow | view.properties view.nextPane "
         "view.previousPane | "
         "view.fullScreen"},
        {QT_TR_NOOP("&Section"),
         "section.symmetry section.ground section.snap | section.pen >plane | section.redraw "
         "section.addHole section.removeHoles >shapes >points >drawing >marks | "
         "section.transform "
         "transform.inSpace "
         "transform.withChildren | section.putOn section.free section.makeOrthogonal "
         "section.snapNormal section.dropToGround section.lock | joint.flip joint.reset"},
        {QT_TR_NOOP("&Operation"),
         "operation.linear operation.revolve operation.blend operation.branch operation.grid "
         "operation.radial | operation.mirror operation.rotational operation.array "
         "operation.symmetric | "
         "operation.switch operation.moveUp operation.moveDown | "
         "operation.editSource operation.detach operation.leaveOut operation.bake"},
        {QT_TR_NOOP("&Checks"), "check.nextProblem check.previousProblem | check.showAssembly"},
        {QT_TR_NOOP("F&abricate"), "fabricate.stocks | file.export"},
        {QT_TR_NOOP("&Help"), "edit.find help.start | help.about"},
        {QT_TR_NOOP("&Mirror copy"),
         "edit.mirrorCopyX edit.mirrorCopyY edit.mirrorCopyZ edit.mirrorCopySection", "mirrorCopy"},
        {QT_TR_NOOP("Draw on a p&lane"),
         "section.planeGround section.planeFront section.planeSide section.planeParallel", "plane"},
        {QT_TR_NOOP("&Text and marks"), "section.mark | mark.engrave mark.score", "marks"},
        {QT_TR_NOOP("From S&VG"),
         "section.importSections section.importContour section.importHoles section.importMarks",
         "drawing"},
        {QT_TR_NOOP("Shape b&y numbers"),
         "section.addShape | section.addCircle section.addEllipse section.addRectangle "
         "section.addPolygon "
         "section.addStar section.addSlot",
         "shapes"},
        {QT_TR_NOOP("P&oints"),
         "point.insert point.delete | point.smooth point.symmetric point.corner", "points"},
        {"",
         "section.transform section.redraw section.addHole section.removeHoles >shapes >drawing "
         "section.mark | edit.cut "
         "edit.copy "
         "edit.paste edit.duplicate >mirrorCopy edit.delete | section.putOn section.free "
         "section.makeOrthogonal section.snapNormal section.lock | view.faceSelection "
         "view.fitSelection view.isolate view.hide | edit.selectConnected edit.selectParallel "
         "edit.selectSameStock",
         "context.section"},
        {"",
         "operation.editSource operation.detach operation.leaveOut | edit.copy edit.duplicate "
         ">mirrorCopy | view.faceSelection view.fitSelection view.isolate view.hide | "
         "edit.selectConnected edit.selectParallel edit.selectSameStock | operation.switch "
         "operation.bake",
         "context.made"},
        {"",
         "operation.editSource | edit.copy edit.duplicate edit.delete | operation.switch "
         "operation.moveUp operation.moveDown operation.bake | view.fitSelection view.isolate "
         "view.hide",
         "context.operation"},
        {"", "point.smooth point.symmetric point.corner | point.insert point.delete",
         "context.point"},
        {"",
         "point.insert | section.transform section.redraw section.addHole >shapes | edit.copy "
         "edit.duplicate edit.delete",
         "context.contour"},
        {"", "joint.flip joint.reset | view.fitSelection", "context.joint"},
        {"",
         "edit.paste | edit.selectAll view.showAll | >plane section.pen >shapes >drawing | "
         "measure.ruler measure.dimension | view.fitAll "
         "view.iso "
         "view.front view.top view.right view.previous | view.perspective view.xray view.clip",
         "context.empty"},
    };
    return kMenus;
}

} // namespace

std::span<const ActionRow> actionTable()
{
    return Texts::actions();
}

std::span<const MenuRow> menuTable()
{
    return Texts::menus();
}

} // namespace fff::ui
