  vec4 umbraCovered;
  vec4 umbraSurface = umbraShade(vertexVC.xyz, normalVCVSOutput, umbraCovered);
  vec3 umbraLight = umbraSurface.w * lightColor0;
  gl_FragData[1] = umbraSurface;
#if UMBRA_FOOTPRINTS
  gl_FragData[2] = umbraCovered;
#endif
