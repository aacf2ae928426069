# The readers of meshes, which need no Embree: for the plugin, and for the fuzzers, which build nothing else of it.
add_library(hogelscope_mesh_readers STATIC
  ${CMAKE_CURRENT_LIST_DIR}/errors.cpp
  ${CMAKE_CURRENT_LIST_DIR}/found_files.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_accessors.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_animation.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_data.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_layers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_materials.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_motion.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_nodes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_skins.cpp
  ${CMAKE_CURRENT_LIST_DIR}/mesh.cpp
  ${CMAKE_CURRENT_LIST_DIR}/mesh_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/mtl_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/obj_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/picture.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ply_header.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ply_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/reading.cpp
  ${CMAKE_CURRENT_LIST_DIR}/srgb.cpp
  ${CMAKE_CURRENT_LIST_DIR}/texture.cpp
  ${CMAKE_CURRENT_LIST_DIR}/textures.cpp)
target_include_directories(hogelscope_mesh_readers PUBLIC ${CMAKE_CURRENT_LIST_DIR}
  ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/src/sdk)
target_compile_features(hogelscope_mesh_readers PUBLIC cxx_std_20)
target_link_libraries(hogelscope_mesh_readers PRIVATE nlohmann_json::nlohmann_json
  OpenImageIO::OpenImageIO PkgConfig::spng)
