// SPDX-License-Identifier: BSD-3-Clause
// Plugins on disk for tests of finding and loading them.
#pragma once

#include <QFile>
#include <QMap>

#include "io/plugins/plugin_list.h"
#include "sdk/hogelscope/plugin.h"
#include "tests/io/documents.h"

/// The JSON of each key, by name; an empty one is omitted.
using Keys = QMap<QString, QByteArray>;

/// Returns the document of a plugin whose library has `bytes` bytes, with some keys changed.
inline QByteArray pluginJson(qint64 bytes, const Keys& changes = {}) {
  Keys keys{{"name", "\"wrong\""},
            {"version", "\"1.0\""},
            {"kinds", "[\"content\", \"lens\", \"metric\"]"},
            {"abi", QByteArray::number(hogelscope::plugin::abi)},
            {"build", "\"" HOGELSCOPE_PLUGIN_BUILD "\""},
            {"file", "\"wrong.so\""},
            {"bytes", QByteArray::number(bytes)}};
  keys.insert(changes);
  QByteArray text;
  for (auto key = keys.begin(); key != keys.end(); ++key)
    if (!key->isEmpty())
      text += (text.isEmpty() ? "{\"" : ", \"") + key.key().toUtf8() + "\": " + *key;
  return text + "}";
}

/// Creates `folder` with the library and its document, replacing existing ones.
inline void writePlugin(const QString& folder, const QByteArray& library,
                        const Keys& changes = {}) {
  QDir(folder).removeRecursively();
  writeFile(folder + "/wrong.so", library);
  writeFile(folder + "/plugin.json", pluginJson(library.size(), changes));
}

/// Returns the plugin of this folder, which must exist.
inline hogelscope::FoundPlugin foundIn(const QString& folder) {
  for (const hogelscope::FoundPlugin& found : hogelscope::listPlugins())
    if (found.folder == QFileInfo(folder).absoluteFilePath().toStdString()) return found;
  qFatal("no plugin is found in %s", qPrintable(folder));
}
