# cpack -G DEB: one package with the programs, what shots include, examples, manual and completions.
set(CPACK_PACKAGE_NAME carom)
set(CPACK_PACKAGE_VENDOR "The carom authors")
set(CPACK_PACKAGE_CONTACT "The carom authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "films of billiard-style shots, simulated and ray traced")
set(CPACK_PACKAGE_DESCRIPTION
"A shot is written in YAML, simulated with ODE and baked into timelines; a path tracer with true motion blur and
depth of field films these, at any speed, backwards or from another seat, and writes an MP4.")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# The libraries are found by dpkg-shlibdeps; a font is no library.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
include(CPack)

# What belongs to no program. Examples stand beside the configs that they include.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION share/carom)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md
  DESTINATION share/doc/carom)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION share/doc/carom)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/carom RENAME copyright)
