// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/sections.h"

#include "core/base/error.h"

namespace hogelscope {

void SectionVisitor::items(std::string_view /*name*/, std::string_view /*what*/, std::size_t count,
                           const std::function<void(std::size_t count)>& /*resize*/,
                           const std::function<void(std::size_t index)>& visit) {
  for (std::size_t k = 0; k < count; ++k) visit(k);
}

SectionReader::SectionReader(const Json& object, const std::string& path, Load load)
    : m_load(std::move(load)) {
  m_open.emplace_back(object, path);
}

bool SectionReader::begin(std::string_view name, bool /*isWritten*/) {
  const Json* const object = m_open.back().section(name);
  if (object == nullptr) return false;
  m_open.emplace_back(*object, m_open.back().pathOf(name));
  return true;
}

void SectionReader::end() {
  m_open.back().refuseUnknown();
  for (; !m_checks.empty() && m_checks.back().first == m_open.size(); m_checks.pop_back()) try {
      m_checks.back().second();
    } catch (const InputError& error) {
      throw InputError(m_open.back().pathOf(error.what()), "");
    }
  m_open.pop_back();
}

bool SectionReader::document(std::string_view name, std::string& file, bool /*isWritten*/,
                             const Visit& visit) {
  const Json* object = m_open.back().section(name);
  if (object == nullptr) return false;
  const std::string path = m_open.back().pathOf(name);
  if (object->is_string() && m_load) {
    file = object->get<std::string>();
    object = &m_loaded.emplace_back(m_load(path, file));
  }
  m_open.emplace_back(*object, path);
  visit();
  end();
  return true;
}

bool SectionReader::value(std::string_view name, bool /*isWritten*/, const ReadValue& read,
                          const WriteValue& /*write*/) {
  const Json* const found = m_open.back().section(name);
  if (found == nullptr) return false;
  read(*found, m_open.back().pathOf(name));
  return true;
}

void SectionReader::refuse(std::string_view name, std::string_view why) {
  if (m_open.back().has(name)) throw InputError(m_open.back().pathOf(name), std::string(why));
}

void SectionReader::verify(const Visit& check) {
  m_checks.emplace_back(m_open.size(), check);
}

void SectionReader::items(std::string_view name, std::string_view what, std::size_t /*count*/,
                          const std::function<void(std::size_t count)>& resize,
                          const std::function<void(std::size_t index)>& visit) {
  const Json* const list = m_open.back().section(name);
  if (list == nullptr) return;
  const std::string path = m_open.back().pathOf(name);
  if (!list->is_array())
    throw InputError(path, "is not a list of " + std::string(what) + ": [ { … }, … ]");
  resize(list->size());
  for (std::size_t k = 0; k < list->size(); ++k) {
    m_open.emplace_back((*list)[k], path + "[" + std::to_string(k) + "]");
    visit(k);
    end();
  }
}

bool SectionWriter::begin(std::string_view name, bool isWritten) {
  if (!isWritten) return false;
  m_open.push_back(Json::object());
  m_names.emplace_back(name);
  return true;
}

void SectionWriter::end() {
  Json object = std::move(m_open.back());
  m_open.pop_back();
  m_open.back()[m_names.back()] = std::move(object);
  m_names.pop_back();
}

bool SectionWriter::document(std::string_view name, std::string& file, bool isWritten,
                             const Visit& visit) {
  if (file.empty())
    section(name, isWritten, visit);
  else
    m_open.back()[std::string(name)] = file;
  return isWritten;
}

bool SectionWriter::value(std::string_view name, bool isWritten, const ReadValue& /*read*/,
                          const WriteValue& write) {
  if (isWritten) m_open.back()[std::string(name)] = write();
  return true;
}

void SectionWriter::leaveOut(std::string_view field) {
  m_open.back().erase(std::string(field));
}

void SectionWriter::items(std::string_view name, std::string_view /*what*/, std::size_t count,
                          const std::function<void(std::size_t count)>& /*resize*/,
                          const std::function<void(std::size_t index)>& visit) {
  Json list = Json::array();
  for (std::size_t k = 0; k < count; ++k) {
    m_open.push_back(Json::object());
    visit(k);
    list.push_back(std::move(m_open.back()));
    m_open.pop_back();
  }
  m_open.back()[std::string(name)] = std::move(list);
}

bool FileVisitor::document(std::string_view /*name*/, std::string& name, bool isWritten,
                           const Visit& visit) {
  file(name);
  visit();
  return isWritten;
}

void FileVisitor::file(std::string& name) {
  if (!name.empty()) name = m_change(name);
}

}  // namespace hogelscope
