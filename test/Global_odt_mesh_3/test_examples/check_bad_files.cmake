# Runs the example PROGRAM on files of the kind SURFACE or IMAGE that it cannot use, made in the current directory, and checks that it
# says why, and fails in an orderly way.
function(refuses name complaint)
  execute_process(COMMAND ${PROGRAM} ${name} RESULT_VARIABLE result ERROR_VARIABLE errors OUTPUT_VARIABLE output)
  if(NOT result STREQUAL 1)
    message(SEND_ERROR "${name}: the exit code is ${result}")
  endif()
  if(NOT errors MATCHES "${name} ${complaint}")
    message(SEND_ERROR "${name}: ${errors}")
  endif()
endfunction()

refuses(missing "cannot be opened")
file(WRITE text "no surface, nor an image\n")
if(KIND STREQUAL IMAGE)
  refuses(text "is not an image")
  return()
endif()
refuses(text "is not a 2-manifold surface")
file(WRITE empty.off "OFF\n0 0 0\n")
refuses(empty.off "(has no facets|is not a 2-manifold surface)")
file(WRITE points.off "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")
refuses(points.off "(has no facets|is not a 2-manifold surface)")
file(WRITE open.off "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n")
refuses(open.off "is not closed")
file(WRITE cube.off "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
refuses(cube.off "has facets that are not triangles")
# Two tetrahedra, one of which sticks out of the other.
file(WRITE crossing.off "OFF\n8 8 0\n0 0 0\n3 0 0\n0 3 0\n0 0 3\n0.5 0.5 0.5\n3.5 0.5 0.5\n0.5 3.5 0.5\n0.5 0.5 3.5\n"
                        "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n")
refuses(crossing.off "intersects itself")
