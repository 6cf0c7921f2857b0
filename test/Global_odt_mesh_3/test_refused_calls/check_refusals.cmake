# Builds TARGET, whose SOURCE has nothing but calls that must be refused, in the directory BUILD, and checks that there is
# an error for each, except for those whose names match ABSENT, and none but those of our static assertions.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${TARGET}
                OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
if(result EQUAL 0)
  message(FATAL_ERROR "all calls compile")
endif()

# Not to be taken for lists.
string(REPLACE ";" "," output "${output}")
file(READ ${SOURCE} source)
string(REPLACE ";" "," source "${source}")
string(REGEX MATCHALL "#line 1 \"[a-z_]+\"" calls "${source}")
foreach(call ${calls})
  string(REGEX REPLACE "#line 1 \"(.*)\"" "\\1" call ${call})
  if(NOT call MATCHES "${ABSENT}" AND NOT output MATCHES "[^a-z_]${call}:1:")
    message(SEND_ERROR "not refused: ${call}")
  endif()
endforeach()

string(REGEX MATCHALL "[^\n]* error: [^\n]*" errors "${output}")
list(FILTER errors EXCLUDE REGEX "is no named parameter|a named parameter is|this named parameter is read by|too many errors")
if(errors)
  message(SEND_ERROR "other errors: ${errors}")
endif()
