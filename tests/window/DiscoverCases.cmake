# Run after window_test is linked: writes a CTest entry for each case that the program lists.
# PROGRAM, XVFB_RUN and FILE are given.
execute_process(COMMAND ${PROGRAM} --list OUTPUT_VARIABLE listed RESULT_VARIABLE result TIMEOUT 60)
string(REGEX REPLACE "\n$" "" listed "${listed}")
string(REPLACE "\n" ";" cases "${listed}")
if(result OR NOT cases)
  message(FATAL_ERROR "${PROGRAM} --list: ${result}")
endif()
set(text "")
foreach(case IN LISTS cases)
  string(APPEND text
    "add_test([[Window.${case}]] [[${XVFB_RUN}]] -a -s [[-screen 0 1680x1000x24]] [[${PROGRAM}]] ${case})\n"
    "set_tests_properties([[Window.${case}]] PROPERTIES TIMEOUT 300)\n")
endforeach()
file(WRITE ${FILE} "${text}")
