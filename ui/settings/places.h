// Where the program keeps what is a person's: settings, work that a crash would lose, pictures of
// models.
//
// A file "portable.txt" beside the program is for sticks and classrooms: nothing of a person is
// then left on the computer, nor beside the program unless the file says so. Its first line that
// is not a comment (#) names a folder, as seen from the program's, in which all is kept:
//
//     (empty)        while the program runs; unsaved work until the person logs out
//     my settings    in "my settings" beside the program; as if empty where it cannot be written
//
// Files "defaults.ini", beside the program and where the system keeps settings for all
// (/etc/xdg/flatfitfab and its like), are for whoever looks after computers: what they say counts
// until a person sets it otherwise. They are never written.
#pragma once

#include <QString>
#include <QStringList>

namespace fff::ui {

struct Places
{
    QString settings;          // an INI file
    QString data;              // folder: recovered work, reports
    QString cache;             // folder: what can be made again
    QStringList defaults = {}; // INI files, that one first that counts before the others
};

/// Those of a program in this folder.
Places placesFor(const QString &programFolder);

/// Those of this program; there has to be an application.
Places places();

} // namespace fff::ui
