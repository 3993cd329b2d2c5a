// What FlatFitFab is built with, and under which licences: for About.
#pragma once

#include <QString>

#include <span>

namespace fff::ui {

struct Library
{
    const char *name;
    const char *purpose; // English; AboutDialog::tr() looks it up
    const char *copyright;
    const char *licence; // its name
    const char *file;    // of its text, :/licences/FILE.txt
    const char *address;
};

/// The first is FlatFitFab itself.
std::span<const Library> libraries();

QString licenceText(const Library &library);

/// What a bug report needs: versions of the program, of Qt and of the graphics driver, the system.
/// English, one fact a line.
QString versionReport();

} // namespace fff::ui
