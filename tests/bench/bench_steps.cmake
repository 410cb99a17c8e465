find_package(SUNDIALS QUIET COMPONENTS cvode nvecserial)
if(SUNDIALS_FOUND)
  target_link_libraries(${name} PRIVATE SUNDIALS::cvode SUNDIALS::nvecserial)
else()  # whoever only runs the programs has none
  set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
