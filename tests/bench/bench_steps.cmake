find_package(SUNDIALS REQUIRED COMPONENTS cvode nvecserial)
target_link_libraries(${name} PRIVATE SUNDIALS::cvode SUNDIALS::nvecserial)
