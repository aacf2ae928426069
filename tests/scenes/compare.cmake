cmake_minimum_required(VERSION 3.25)
# Renders SESSION to OUTPUT and compares each picture with the one in REFERENCE. A reference that is
# missing is written, and the test fails.
file(REMOVE_RECURSE ${OUTPUT})
execute_process(COMMAND ${PROGRAM} --render --masks --quiet --session ${SESSION} --output ${OUTPUT}
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "--render ended with ${status}")
endif()
file(GLOB pictures RELATIVE ${OUTPUT} ${OUTPUT}/*.png)
file(GLOB references RELATIVE ${REFERENCE} ${REFERENCE}/*.png)
foreach(picture ${references})
  if(NOT picture IN_LIST pictures)
    message(SEND_ERROR "${picture} was not rendered")
  endif()
endforeach()
foreach(picture ${pictures})
  if(NOT EXISTS ${REFERENCE}/${picture})
    file(COPY ${OUTPUT}/${picture} DESTINATION ${REFERENCE})
    message(SEND_ERROR "no reference: ${REFERENCE}/${picture} is written; look at it, then commit it")
    continue()
  endif()
  # One code value in 0.02 % of the pixels, three in any.
  execute_process(COMMAND idiff -fail 0.004 -failpercent 0.02 -hardfail 0.012 -warn 1
    ${REFERENCE}/${picture} ${OUTPUT}/${picture} RESULT_VARIABLE differs OUTPUT_VARIABLE text)
  if(NOT differs EQUAL 0)
    message(SEND_ERROR "${picture} differs from its reference:\n${text}")
  endif()
endforeach()
